package org.maestro.coordination;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.maestro.knowledge.FeatureRun;
import org.maestro.planning.StepKey;

/**
 * Remembers failed steps with the facts under their preconditions. A step that failed twice with
 * the same facts is barred until one of them changes: so that a goal never tries the same in vain
 * for ever. Before the goal is given up each has one chance more.
 */
final class FailureMemory {
  private static final int CHANCES = 2;

  private final String goalId;
  private final Journal journal;
  private final Map<StepKey, JournalEntry.Failed> failures = new LinkedHashMap<>();

  /**
   * @param journal where it is written down, to be remembered beyond a restart
   */
  FailureMemory(String goalId, Journal journal) {
    this.goalId = goalId;
    this.journal = journal;
  }

  /** What was remembered before a restart. */
  void takeUp(List<JournalEntry.Failed> former) {
    former.forEach(failed -> failures.put(failed.step(), failed));
  }

  /**
   * @param problem what its member says
   * @param taught what it teaches
   */
  void note(StepKey step, String facts, String problem, List<FeatureRun.Learnt> taught) {
    String said = Sentences.withoutFullStop(problem);
    JournalEntry.Failed before = failures.get(step);
    remember(
        before != null && before.facts().equals(facts)
            ? new JournalEntry.Failed(
                goalId, step, facts, before.count() + 1, before.chances(), said, taught)
            : new JournalEntry.Failed(goalId, step, facts, 1, CHANCES, said, taught));
  }

  private void remember(JournalEntry.Failed failed) {
    failures.put(failed.step(), failed);
    journal.write(failed);
  }

  /**
   * The steps barred now, and why; {@code factsUnder} tells the facts under a step's precondition
   * as they are.
   */
  Map<StepKey, String> barred(Function<StepKey, String> factsUnder) {
    Map<StepKey, String> barred = new LinkedHashMap<>();
    failures.forEach(
        (step, failed) -> {
          if (isBarred(step, failed, factsUnder)) {
            barred.put(
                step,
                "it failed %d times with the same facts: %s"
                    .formatted(failed.count(), failed.problem()));
          }
        });
    return barred;
  }

  private static boolean isBarred(
      StepKey step, JournalEntry.Failed failed, Function<StepKey, String> factsUnder) {
    return failed.count() >= failed.chances() && failed.facts().equals(factsUnder.apply(step));
  }

  /** The member says that it can do the feature now, whatever was before. */
  void pardon(String member, String feature) {
    List<JournalEntry.Failed> pardoned =
        failures.values().stream()
            .filter(failed -> failed.step().member().equals(member))
            .filter(failed -> failed.step().feature().equals(feature))
            .toList();
    for (JournalEntry.Failed failed : pardoned) {
      remember(
          new JournalEntry.Failed(
              goalId,
              failed.step(),
              failed.facts(),
              0,
              failed.chances(),
              failed.problem(),
              failed.taught()));
    }
  }

  /** Gives each barred step that had none its last chance; returns whether there was any. */
  boolean giveLastChances(Function<StepKey, String> factsUnder) {
    List<JournalEntry.Failed> given =
        failures.values().stream()
            .filter(failed -> failed.chances() <= CHANCES)
            .filter(failed -> isBarred(failed.step(), failed, factsUnder))
            .toList();
    for (JournalEntry.Failed failed : given) {
      remember(
          new JournalEntry.Failed(
              goalId,
              failed.step(),
              failed.facts(),
              failed.count(),
              CHANCES + 1,
              failed.problem(),
              failed.taught()));
    }
    return !given.isEmpty();
  }
}
