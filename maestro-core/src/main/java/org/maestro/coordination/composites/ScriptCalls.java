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
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Ports;
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
 * goal for whose plan it is. The journal has it as a call of that part's id, by which the script
 * goes on after a restart.
 */
final class ScriptCalls implements ActionDispatcher {
  private final ActionDispatcher agents;
  private final KnowledgeBase knowledge;
  private final Clock clock;
  private final Journal journal;
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
    this.journal = ports.journal();
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
    Formula.Atom goal = new Formula.Atom(script, arguments);
    String id = order.call().map(Call::id).orElseGet(() -> nextId(order.goalId()));
    Consumer<GoalOutcome> ended =
        outcome -> {
          Report report = report(script, outcome, promised);
          journal.write(new JournalEntry.Ended(order.goalId(), id, report.problem()));
          reported.accept(report);
        };
    if (order.call().isPresent()) {
      runsByGoal.merge(order.goalId(), GoalId.lastNumber(id), Math::max);
      return handle(runs.takeUp(id, goal, within.apply(script), ended));
    }
    journal.write(
        new JournalEntry.Begun(
            order.goalId(),
            new Call(id, Optional.empty()),
            step.key(),
            step.number(),
            step.seconds(),
            order.parameters(),
            order.timeout()));
    return handle(runs.begin(id, goal, within.apply(script), ended));
  }

  private String nextId(String goalId) {
    int number = runsByGoal.merge(goalId, 1, Integer::sum);
    return GoalId.part(goalId, String.valueOf(number));
  }

  private Handle handle(Runnable cancelling) {
    return new Handle() {
      @Override
      public void cancel() {
        cancelling.run();
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
    if (member.equals(Script.PLANNED_AS)) {
      runs.giveUp(call.id());
    } else {
      agents.callOff(member, call);
    }
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
