package org.maestro.coordination.lessons;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.coordination.facts.FactsUnder;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.EffectTarget;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * Steps of one goal that were said to be done and were needed again, each with what was known
 * before it: as nothing had changed, they were done in vain. The same feature of the same member on
 * the same things is one deed, whatever its amounts: a pump that says that it waters and does not
 * is not to be asked for every amount there is. The coordinator's thread only.
 */
public final class VainDeeds {
  private final Map<StepKey, String> done = new HashMap<>();
  private final Map<Deed, Repeated> deeds = new HashMap<>();

  /** Steps that may be tried only once and were, with the facts that they rested on. */
  private final Map<StepKey, String> spent = new LinkedHashMap<>();

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
   * What is told of the targets, and not only expected.
   *
   * @param latest when it was told last
   */
  private record Told(String facts, Instant latest) {
    Told or(Told later) {
      return later.latest().isAfter(latest) ? later : this;
    }
  }

  /**
   * @param from what was told each time before it was done
   * @param told what was told last
   * @param judged when what was told was compared last
   * @param times how often it was done
   * @param inVain how often in a row from where it had been begun already
   * @param tries how often it may be tried from there, the last chance included
   * @param cameOfIt whether things were otherwise for a while
   */
  private record Repeated(
      List<String> from,
      Told told,
      Instant judged,
      int times,
      int inVain,
      int tries,
      boolean cameOfIt) {

    static Repeated once(Told told, int tries) {
      return new Repeated(List.of(told.facts()), told, told.latest(), 1, 0, tries, false);
    }

    Repeated told(Told now) {
      Told latest = told.or(now);
      boolean isOtherwise = !from.contains(latest.facts());
      return new Repeated(from, latest, judged, times, inVain, tries, cameOfIt || isOtherwise);
    }

    /** As long as nobody has told anything since, nothing shows what has come of it. */
    boolean isJudged() {
      return !told.latest().isAfter(judged);
    }

    boolean isWhereItBegan() {
      return from.contains(told.facts());
    }

    Repeated again() {
      if (isJudged()) {
        return new Repeated(from, told, judged, times + 1, inVain, tries, cameOfIt);
      }
      List<String> all = new ArrayList<>(from);
      if (!isWhereItBegan()) {
        all.add(told.facts());
      }
      return new Repeated(
          List.copyOf(all),
          told,
          told.latest(),
          times + 1,
          isWhereItBegan() ? inVain + 1 : 0,
          tries,
          cameOfIt);
    }

    boolean hasALastChance() {
      return isTooOften() && tries > 1;
    }

    Repeated withALastChance() {
      return new Repeated(from, told, told.latest(), times, tries - 2, tries, cameOfIt);
    }

    boolean isTooOften() {
      return isWhereItBegan() && inVain + (isJudged() ? 0 : 1) >= Math.max(1, tries - 1);
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
   * @param before what was known when it was begun
   */
  public void said(Step step, Snapshot before) {
    Deed deed = deed(step);
    if (deed.targets().isEmpty()) {
      return;
    }
    deeds.keySet().removeIf(other -> !other.equals(deed) && other.concerns(deed));
    Told told = told(deed, before);
    deeds.merge(
        deed,
        Repeated.once(told, step.feature().reliability().tries()),
        (former, first) -> former.told(told).again());
  }

  /** What is known has changed. */
  public void look(Snapshot now) {
    deeds.replaceAll((deed, repeated) -> repeated.told(told(deed, now)));
  }

  /**
   * Why the step is left alone as things are.
   *
   * @return part of a sentence; empty when it is not left alone
   */
  public Optional<String> leftAlone(Step step, Snapshot now) {
    Deed deed = deed(step);
    return Optional.ofNullable(deeds.get(deed))
        .map(repeated -> repeated.told(told(deed, now)))
        .filter(Repeated::isTooOften)
        .map(
            repeated ->
                "%s said %d times that it had done %s, and %s when it was needed again"
                    .formatted(
                        deed.member(),
                        repeated.times(),
                        deed.feature(),
                        repeated.cameOfIt()
                            ? "what had come of it was gone"
                            : "nothing had changed"));
  }

  /**
   * The step may be tried only once, and was.
   *
   * @param facts on which it rested
   */
  public void spent(StepKey step, String facts) {
    spent.put(step, facts);
  }

  /** Steps that may not be tried again as things are, each with the reason. */
  public Map<StepKey, String> spent(Function<StepKey, String> factsUnder) {
    Map<StepKey, String> barred = new LinkedHashMap<>();
    spent.forEach(
        (step, facts) -> {
          if (FactsUnder.areSame(facts, factsUnder.apply(step))) {
            barred.put(step, "it may be tried only once, and was");
          }
        });
    return barred;
  }

  /** Lets each deed that is left alone be done once more; returns whether there is any. */
  public boolean giveLastChances() {
    boolean any = deeds.values().stream().anyMatch(Repeated::hasALastChance);
    deeds.replaceAll(
        (deed, repeated) -> repeated.hasALastChance() ? repeated.withALastChance() : repeated);
    return any;
  }

  /** The goal is reached: what was done was not in vain. */
  public void reached() {
    done.clear();
    deeds.clear();
    spent.clear();
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

  private static Told told(Deed deed, Snapshot snapshot) {
    SortedMap<String, Belief> latest = new TreeMap<>();
    for (Formula.Atom target : deed.targets()) {
      claims(target, snapshot)
          .filter(claim -> claim.source().kind() != Source.Kind.EXPECTED)
          .max(Comparator.comparing(Belief::since))
          .ifPresent(claim -> latest.put(SlPrinter.print(target), claim));
    }
    return new Told(
        latest.entrySet().stream()
            .map(entry -> entry.getKey() + " " + entry.getValue().fact())
            .collect(Collectors.joining(" ")),
        latest.values().stream()
            .map(Belief::since)
            .max(Comparator.naturalOrder())
            .orElse(Instant.MIN));
  }

  /** Of a number, or else of whether it is so. */
  private static Stream<Belief> claims(Formula.Atom target, Snapshot snapshot) {
    List<Belief> ofNumber =
        snapshot.claims(new Expression.Fluent(target.predicate(), target.arguments()));
    return (ofNumber.isEmpty() ? snapshot.claims(target) : ofNumber).stream();
  }
}
