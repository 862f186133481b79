package org.maestro.coordination.lessons;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.facts.FactsUnder;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.EffectTarget;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * Steps of one goal that were said to be done and were needed again, each with what was known
 * before it: as nothing had changed, they were done in vain. The same feature of the same member on
 * the same things is one deed, whatever its amounts: a pump that says that it waters and does not
 * is not to be asked for every amount there is. The coordinator's thread only.
 */
public final class VainDeeds {
  /** After so many repetitions in a row a deed is left alone. */
  private static final int MOST_REPETITIONS = 2;

  private final Map<StepKey, String> done = new HashMap<>();
  private final Map<Deed, Repeated> deeds = new HashMap<>();

  /** What a member's feature changes. */
  private record Deed(String member, String feature, Set<Formula.Atom> targets) {
    boolean concerns(Deed other) {
      return targets.stream()
          .anyMatch(one -> other.targets().stream().anyMatch(it -> meet(one, it)));
    }

    private static boolean meet(Formula.Atom one, Formula.Atom other) {
      return one.predicate().equals(other.predicate())
          && (one.arguments().isEmpty()
              || one.arguments().stream().anyMatch(other.arguments()::contains));
    }
  }

  /**
   * @param before what was known of its targets each time before it was done
   * @param times how often it was done
   * @param inVain how often in a row from where it had been begun already
   */
  private record Repeated(List<String> before, int times, int inVain) {
    static final Repeated NEVER = new Repeated(List.of(), 0, 0);

    boolean wasBegunFrom(String facts) {
      return before.stream().anyMatch(former -> FactsUnder.areSame(former, facts));
    }

    Repeated with(String facts) {
      boolean again = wasBegunFrom(facts);
      List<String> all = new ArrayList<>(before);
      if (!again) {
        all.add(facts);
      }
      return new Repeated(List.copyOf(all), times + 1, again ? inVain + 1 : 0);
    }

    boolean isTooOften() {
      return inVain >= MOST_REPETITIONS;
    }
  }

  /** The step is said to be done; returns whether it was before, and nothing has come of it. */
  public boolean isVain(StepKey step, String facts) {
    String before = done.put(step, facts);
    return before != null && FactsUnder.areSame(before, facts);
  }

  /**
   * The step is said to be done.
   *
   * @param before when it was begun
   */
  public void said(Step step, Snapshot before) {
    Deed deed = deed(step);
    if (deed.targets().isEmpty()) {
      return;
    }
    deeds.keySet().removeIf(other -> !other.equals(deed) && other.concerns(deed));
    deeds.merge(
        deed,
        Repeated.NEVER.with(facts(deed, before)),
        (former, first) -> former.with(facts(deed, before)));
  }

  /**
   * Why the step is left alone as things are.
   *
   * @return part of a sentence; empty when it is not left alone
   */
  public Optional<String> leftAlone(Step step, Snapshot now) {
    Deed deed = deed(step);
    return Optional.ofNullable(deeds.get(deed))
        .filter(Repeated::isTooOften)
        .filter(repeated -> repeated.wasBegunFrom(facts(deed, now)))
        .map(
            repeated ->
                "%s said %d times that it had done %s, and nothing had changed when it was needed again"
                    .formatted(deed.member(), repeated.times(), deed.feature()));
  }

  /** Lets each deed that is left alone be done once more; returns whether there is any. */
  public boolean giveLastChances() {
    boolean any = deeds.values().stream().anyMatch(Repeated::isTooOften);
    deeds.replaceAll(
        (deed, repeated) ->
            repeated.isTooOften()
                ? new Repeated(repeated.before(), repeated.times(), MOST_REPETITIONS - 1)
                : repeated);
    return any;
  }

  /** The goal is reached: what was done was not in vain. */
  public void reached() {
    done.clear();
    deeds.clear();
  }

  private static Deed deed(Step step) {
    Substitution substitution = new Substitution(step.values());
    Set<Formula.Atom> targets = new HashSet<>();
    for (EffectTarget target : EffectTarget.of(step.feature().effect())) {
      Formula.Atom atom =
          substitution.apply(new Formula.Atom(target.name(), List.copyOf(target.arguments())));
      if (atom.arguments().stream().allMatch(Term::isGround)) {
        targets.add(atom);
      }
    }
    return new Deed(step.member(), step.feature().name(), targets);
  }

  private static String facts(Deed deed, Snapshot snapshot) {
    return FactsUnder.with("", deed.targets(), snapshot);
  }
}
