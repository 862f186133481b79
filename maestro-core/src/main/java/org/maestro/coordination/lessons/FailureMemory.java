package org.maestro.coordination.lessons;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.ToIntFunction;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.facts.FactsUnder;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Formula;

/**
 * Remembers failed steps with the facts under their preconditions. A step that failed so often as
 * its feature may be tried, but for one last time, or was refused once, is barred until one of them
 * changes: so that a goal never tries the same in vain for ever. Before the goal is given up each
 * has its last chance, unless its member says that it would be refused again.
 */
public final class FailureMemory {
  private final String goalId;
  private final Journal journal;
  private final ToIntFunction<StepKey> tries;
  private final Map<StepKey, JournalEntry.Failed> failures = new LinkedHashMap<>();

  /**
   * @param journal where it is written down, to be remembered beyond a restart
   * @param tries how often in all a step may be tried, the last chance included; 1 or more
   */
  public FailureMemory(String goalId, Journal journal, ToIntFunction<StepKey> tries) {
    this.goalId = goalId;
    this.journal = journal;
    this.tries = tries;
  }

  /** What was remembered before a restart. */
  public void takeUp(List<JournalEntry.Failed> former) {
    former.forEach(failed -> failures.put(failed.step(), failed));
  }

  /**
   * @param problem what its member says, without its full stop
   * @param taught what it teaches
   * @param refusal its member says that it cannot be done as things are
   */
  public void note(
      StepKey step,
      String facts,
      String problem,
      List<FeatureRun.Learnt> taught,
      Optional<ActionDispatcher.Refusal> refusal) {
    Optional<JournalEntry.Failed> before =
        Optional.ofNullable(failures.get(step))
            .filter(failed -> FactsUnder.areSame(failed.facts(), facts));
    int count = before.map(failed -> failed.count() + 1).orElse(1);
    int chances = before.map(JournalEntry.Failed::chances).orElse(beforeTheLast(step));
    int withTheLast = tries.applyAsInt(step);
    if (refusal.isPresent() && chances < withTheLast) {
      chances = refusal.get() == ActionDispatcher.Refusal.FOR_NOW ? 1 : withTheLast;
      count = Math.max(count, chances);
    }
    remember(
        new JournalEntry.Failed(
            goalId, step, facts, count, chances, refusal.isPresent(), problem, taught));
  }

  private int beforeTheLast(StepKey step) {
    return Math.max(1, tries.applyAsInt(step) - 1);
  }

  /** What the step's failure has taught of. */
  public Set<Formula.Atom> taught(StepKey step) {
    return Optional.ofNullable(failures.get(step))
        .map(failed -> Insistence.facts(failed.taught()))
        .orElse(Set.of());
  }

  private void remember(JournalEntry.Failed failed) {
    failures.put(failed.step(), failed);
    journal.write(failed);
  }

  /**
   * The steps barred now, and why; {@code factsUnder} tells the facts under a step's precondition
   * as they are.
   */
  public Map<StepKey, String> barred(Function<StepKey, String> factsUnder) {
    Map<StepKey, String> barred = new LinkedHashMap<>();
    failures.forEach(
        (step, failed) -> {
          if (isBarred(step, failed, factsUnder)) {
            barred.put(
                step,
                failed.refused()
                    ? "it was refused, and nothing that it rests on has changed: "
                        + failed.problem()
                    : failed.count() == 1
                        ? "it failed: " + failed.problem()
                        : "it was asked for %d times with the same facts, in vain: %s"
                            .formatted(failed.count(), failed.problem()));
          }
        });
    return barred;
  }

  private static boolean isBarred(
      StepKey step, JournalEntry.Failed failed, Function<StepKey, String> factsUnder) {
    return failed.count() >= failed.chances()
        && FactsUnder.areSame(failed.facts(), factsUnder.apply(step));
  }

  /** The member says that it can do the feature now, whatever was before. */
  public void pardon(String member, String feature) {
    List<JournalEntry.Failed> pardoned =
        failures.values().stream()
            .filter(failed -> failed.step().member().equals(member))
            .filter(failed -> failed.step().feature().equals(feature))
            .toList();
    pardoned.forEach(failed -> remember(failed.with(0, failed.chances())));
  }

  /** Gives each barred step that had none its last chance; returns whether there was any. */
  public boolean giveLastChances(Function<StepKey, String> factsUnder) {
    List<JournalEntry.Failed> given =
        failures.values().stream()
            .filter(failed -> failed.chances() < tries.applyAsInt(failed.step()))
            .filter(failed -> isBarred(failed.step(), failed, factsUnder))
            .toList();
    given.forEach(
        failed ->
            remember(failed.with(beforeTheLast(failed.step()), tries.applyAsInt(failed.step()))));
    return !given.isEmpty();
  }
}
