package org.maestro.coordination.composites;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.Script;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * Orders to agents, and to scripts: a step that is a script has it carried out as a part of the
 * goal for whose plan it is. No journal has such a step, as it is no call: after a restart its goal
 * is planned from what is so then.
 */
final class ScriptCalls implements ActionDispatcher {
  private final ActionDispatcher agents;
  private final KnowledgeBase knowledge;
  private final Clock clock;
  private final ScriptRuns runs;
  private final Function<String, Ports> within;
  private final Map<String, Integer> runsByGoal = new HashMap<>();

  /**
   * @param within the world in which a script of that name does its steps
   */
  ScriptCalls(Ports ports, ScriptRuns runs, Function<String, Ports> within) {
    this.agents = ports.dispatcher();
    this.knowledge = ports.knowledge();
    this.clock = ports.clock();
    this.runs = runs;
    this.within = within;
  }

  @Override
  public Handle perform(Request order, Consumer<Report> reported) {
    Step step = order.step();
    if (!step.member().equals(Script.PLANNED_AS)) {
      return agents.perform(order, reported);
    }
    String script = step.feature().name();
    List<Term> arguments =
        step.feature().inputs().stream().map(Parameter::name).map(step.values()::get).toList();
    PromisedEffect promised = new PromisedEffect(step, knowledge);
    int number = runsByGoal.merge(order.goalId(), 1, Integer::sum);
    ActiveGoal run =
        runs.begin(
            GoalId.part(order.goalId(), String.valueOf(number)),
            new Formula.Atom(script, arguments),
            within.apply(script),
            outcome -> reported.accept(report(script, outcome, promised)));
    return new Handle() {
      @Override
      public void cancel() {
        run.cancel("the goal for which it was run");
      }

      @Override
      public Optional<Duration> aliveAt() {
        return Optional.of(clock.now());
      }
    };
  }

  /** What it has done its steps have reported: by its own failure nothing more is uncertain. */
  private static Report report(String script, GoalOutcome outcome, PromisedEffect promised) {
    Optional<String> problem =
        outcome.reached()
            ? promised.missing().map(facts -> script + " is done, and " + facts)
            : Optional.of(script + " has failed: " + String.join(" ", outcome.reasons()));
    return new Report(problem.isEmpty(), Map.of(), problem, List.of(), problem.isEmpty());
  }

  @Override
  public void callOff(String member, Call call) {
    agents.callOff(member, call);
  }

  @Override
  public void ask(String member, Runnable heard) {
    if (member.equals(Script.PLANNED_AS)) {
      heard.run();
    } else {
      agents.ask(member, heard);
    }
  }

  @Override
  public void alive(String goalId, String member, String feature) {
    agents.alive(goalId, member, feature);
  }

  @Override
  public boolean isOwed(String goalId, StepKey step) {
    return agents.isOwed(goalId, step);
  }

  @Override
  public List<Request> giveUpOwed(String goalId, Predicate<StepKey> unwanted) {
    return agents.giveUpOwed(goalId, unwanted);
  }
}
