package org.maestro.coordination;

import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.composites.ScriptRuns;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.recovery.FormerParts;
import org.maestro.coordination.scripts.ScriptGoal;
import org.maestro.coordination.scripts.Subgoals;
import org.maestro.ontology.home.Script;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Formula;

/**
 * Scripts that are steps of plans, carried out as goals of this coordinator: each is asked for by
 * whoever asked for the goal whose plan it is, and goes as early as that.
 */
final class ScriptsInPlans implements ScriptRuns {
  private final Ports ports;
  private final ActiveGoals activeGoals;
  private final Subgoals subgoals;
  private Optional<FormerParts> former = Optional.empty();

  ScriptsInPlans(Ports ports, ActiveGoals activeGoals, Subgoals subgoals) {
    this.ports = ports;
    this.activeGoals = activeGoals;
    this.subgoals = subgoals;
  }

  /** From now on what was under way before a restart is known. */
  void takeUp(FormerParts parts) {
    former = Optional.of(parts);
  }

  @Override
  public Runnable begin(String id, Formula.Atom script, Ports within, Consumer<GoalOutcome> ended) {
    ActiveGoal run = entered(id, script, within, ended);
    ports
        .journal()
        .accept(
            new JournalEntry.Submitted(id, request(id, script)),
            () -> ports.owner().execute(() -> activeGoals.run(run::start)),
            reason -> activeGoals.run(() -> run.cancel(reason)));
    return () -> cancel(run);
  }

  @Override
  public Runnable takeUp(
      String id, Formula.Atom script, Ports within, Consumer<GoalOutcome> ended) {
    Optional<GoalOutcome> outcome = former.flatMap(parts -> parts.outcome(id));
    if (outcome.isPresent()) {
      Clock.Timer timer =
          ports
              .clock()
              .schedule(
                  ScriptGoal.TELLING,
                  id,
                  () ->
                      ports
                          .owner()
                          .execute(() -> activeGoals.run(() -> ended.accept(outcome.get()))));
      return timer::cancel;
    }
    Optional<Recovery.UnfinishedGoal> before = former.flatMap(parts -> parts.takeUp(id));
    if (before.isEmpty()) {
      return begin(id, script, within, ended);
    }
    ActiveGoal run = entered(id, script, within, ended);
    run.prepareToTakeUp(before.get(), "for what was under way before the restart");
    run.takeUp(before.get(), former.orElseThrow().calls());
    return () -> cancel(run);
  }

  @Override
  public void giveUp(String id) {
    former.ifPresent(parts -> parts.giveUp(id, "the script of which it was a step does not go on"));
  }

  private static void cancel(ActiveGoal run) {
    run.cancel("the goal for which it was run");
  }

  private GoalRequest request(String id, Formula.Atom script) {
    GoalStatus asked = activeGoals.find(GoalId.whole(id)).orElseThrow().status();
    return new GoalRequest(script, asked.requester(), asked.priority(), Optional.empty());
  }

  private ActiveGoal entered(
      String id, Formula.Atom goal, Ports within, Consumer<GoalOutcome> ended) {
    GoalPriority standing = activeGoals.leases().ownStanding(GoalId.whole(id));
    Script script = ScriptGoal.script(goal, ports.knowledge().home().scripts()).orElseThrow();
    ActiveGoal run =
        new ScriptGoal(
            id,
            request(id, goal),
            script,
            standing,
            within.with(ScriptGoal.storyOfPart(id, ports)),
            activeGoals,
            subgoals,
            outcome -> activeGoals.run(() -> ended.accept(outcome)));
    activeGoals.enter(run, standing);
    return run;
  }
}
