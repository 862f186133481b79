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
import org.maestro.coordination.composites.ScriptRuns;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.scripts.ScriptGoal;
import org.maestro.coordination.scripts.Subgoals;
import org.maestro.ontology.home.Script;
import org.maestro.sl.Formula;

/**
 * Scripts that are steps of plans, carried out as goals of this coordinator: each is asked for by
 * whoever asked for the goal whose plan it is, and goes as early as that.
 */
final class ScriptsInPlans implements ScriptRuns {
  private final Ports ports;
  private final ActiveGoals activeGoals;
  private final Subgoals subgoals;

  ScriptsInPlans(Ports ports, ActiveGoals activeGoals, Subgoals subgoals) {
    this.ports = ports;
    this.activeGoals = activeGoals;
    this.subgoals = subgoals;
  }

  @Override
  public ActiveGoal begin(String id, Formula.Atom goal, Ports within, Consumer<GoalOutcome> ended) {
    String whole = GoalId.whole(id);
    GoalStatus asked = activeGoals.find(whole).orElseThrow().status();
    GoalRequest request =
        new GoalRequest(goal, asked.requester(), asked.priority(), Optional.empty());
    GoalPriority standing = activeGoals.leases().ownStanding(whole);
    Script script = ScriptGoal.script(goal, ports.knowledge().home().scripts()).orElseThrow();
    ActiveGoal run =
        new ScriptGoal(
            id,
            request,
            script,
            standing,
            within.with(ScriptGoal.storyOfPart(id, ports)),
            activeGoals,
            subgoals,
            outcome -> activeGoals.run(() -> ended.accept(outcome)));
    activeGoals.enter(run, standing);
    ports
        .journal()
        .accept(
            new JournalEntry.Submitted(id, request),
            () -> ports.owner().execute(() -> activeGoals.run(run::start)),
            reason -> activeGoals.run(() -> run.cancel(reason)));
    return run;
  }
}
