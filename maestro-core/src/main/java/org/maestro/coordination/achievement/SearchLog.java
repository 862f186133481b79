package org.maestro.coordination.achievement;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.SearchReport;
import org.maestro.coordination.facts.Sensing;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The looks of one goal that found nothing. What is known of them ages, and then it may be looked
 * again; but no look is made in vain more often than a few times, so that a search ends.
 */
public final class SearchLog {
  /** Times that the same look may be in vain. */
  public static final int ROUNDS = 3;

  private final String goalId;
  private final Journal journal;
  private final List<JournalEntry.LookedInVain> looks = new ArrayList<>();

  /**
   * @param journal where it is written down, to be remembered beyond a restart
   */
  public SearchLog(String goalId, Journal journal) {
    this.goalId = goalId;
    this.journal = journal;
  }

  /** What was remembered before a restart. */
  void takeUp(List<JournalEntry.LookedInVain> former) {
    looks.addAll(former);
  }

  /** A step has succeeded, and its result is known. */
  void done(
      Step step, Map<String, Term> outputs, Snapshot now, Duration at, Vocabulary vocabulary) {
    Map<String, Term> bindings = step.values();
    for (Formula.Atom atom : Sensing.sought(step.feature().effect(), vocabulary)) {
      Formula.Atom ground = new Substitution(bindings).apply(atom);
      if (ground.isGround() && now.truth(ground) != Truth.TRUE) {
        JournalEntry.LookedInVain vain =
            new JournalEntry.LookedInVain(
                goalId,
                step.key(),
                ground,
                new SearchReport.Look(
                    place(ground), step.member(), at, covered(step, outputs, ground, now)));
        looks.add(vain);
        journal.write(vain);
      }
    }
  }

  /** What the result itself says, or what is known of it. */
  private static OptionalDouble covered(
      Step step, Map<String, Term> outputs, Formula.Atom atom, Snapshot now) {
    for (Parameter output : step.feature().outputs()) {
      if (output.types().contains(Parameter.COVERED_SHARE)
          && outputs.get(output.name()) instanceof Term.Number share) {
        return OptionalDouble.of(share.value());
      }
    }
    return now.belief(atom).map(Belief::coveredShare).orElse(OptionalDouble.empty());
  }

  /** Looks that are not repeated. */
  Set<StepKey> spent() {
    Map<StepKey, Integer> vainByStep = new LinkedHashMap<>();
    looks.forEach(vain -> vainByStep.merge(vain.step(), 1, Integer::sum));
    Set<StepKey> spent = new HashSet<>();
    vainByStep.forEach(
        (step, times) -> {
          if (times >= ROUNDS) {
            spent.add(step);
          }
        });
    return spent;
  }

  /** How many places were looked at, for each thing that was looked for. */
  int places() {
    return (int) looks.stream().map(JournalEntry.LookedInVain::atom).distinct().count();
  }

  /** The latest look at the place that the atom names. */
  Optional<SearchReport.Look> latest(Formula.Atom atom) {
    return looks.stream()
        .filter(vain -> vain.atom().equals(atom))
        .reduce((earlier, later) -> later)
        .map(JournalEntry.LookedInVain::look);
  }

  static String place(Formula.Atom atom) {
    return SlPrinter.print(atom.arguments().get(1));
  }
}
