package org.maestro.planning.export;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.maestro.planning.api.Objective;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.cases.Clause;
import org.maestro.planning.cases.ClauseCompiler;
import org.maestro.planning.cases.NotCarriedException;
import org.maestro.planning.cases.NumberRanges;
import org.maestro.planning.cases.StepCases;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Sought;
import org.maestro.planning.problem.Variable;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * Writes what the planner would solve as PDDL without parameters: an action for each way in which a
 * step that matters can go, as effects with conditions, alternatives and prices that depend on
 * numbers become actions of their own. The cheapest plan of the PDDL costs what the cheapest plan
 * costs that finds everything where it is looked for first.
 */
public final class PddlWriter {
  private static final int COST_PLACES = 9;

  private final GroundProblem problem;
  private final PddlNames names = new PddlNames();
  private final NumberRanges ranges;
  private final ClauseCompiler conditions;
  private final StringBuilder actions = new StringBuilder();
  private final Set<String> functions = new LinkedHashSet<>();
  private final Set<String> clocks = new LinkedHashSet<>();
  private final boolean timed;

  /**
   * The two texts.
   *
   * @param notCarried sentences about what the platform weighs besides, and PDDL cannot say
   */
  public record Texts(String domain, String problem, List<String> notCarried) {
    public Texts {
      notCarried = List.copyOf(notCarried);
    }
  }

  private PddlWriter(GroundProblem problem, boolean timed) {
    this.timed = timed;
    this.problem = problem.placed();
    this.ranges = NumberRanges.of(this.problem);
    this.conditions = new ClauseCompiler(ranges);
  }

  /**
   * The task as PDDL.
   *
   * @param name of the problem
   * @throws NotCarriedException when PDDL has no words for a part of it
   */
  public static Texts write(PlanningTask task, String name) {
    return new PddlWriter(new Grounder(task).ground(), false).texts(task, name);
  }

  /**
   * The task as PDDL+, in which steps take their time: an action begins a step, a process lets it
   * go on, and an event ends it with its effects. What a step occupies nobody else takes meanwhile.
   *
   * @param name of the problem
   * @throws NotCarriedException when PDDL has no words for a part of it
   */
  public static Texts writeTimed(PlanningTask task, String name) {
    return new PddlWriter(new Grounder(task).ground(), true).texts(task, name);
  }

  private Texts texts(PlanningTask task, String name) {
    for (Operator operator : problem.operators()) {
      write(operator);
    }
    String goal = goal();
    String title = PddlNames.plain(name);
    String numeric = functions.isEmpty() && !timed ? "" : " :numeric-fluents";
    String init = initially();
    String domain =
        "(define (domain %s)%n  (:requirements :strips :negative-preconditions :action-costs%s%s)%n"
                .formatted(title, numeric, timed ? " :time" : "")
            + names.declarations()
            + "  (:functions (total-cost) - number%s)%n"
                .formatted(functions.stream().map(f -> "\n    " + f).collect(Collectors.joining()))
            + actions
            + ")\n";
    String problemText =
        "; %s%n(define (problem %s)%n  (:domain %s)%n  (:init (= (total-cost) 0)%s)%n  (:goal %s)%n  (:metric minimize (total-cost)))%n"
            .formatted(
                SlPrinter.print(task.goal()).replaceAll("\\s+", " "), title, title, init, goal);
    return new Texts(unix(domain), unix(problemText), notCarried(task));
  }

  private static String unix(String text) {
    return text.replace(System.lineSeparator(), "\n");
  }

  private List<String> notCarried(PlanningTask task) {
    List<String> sentences = new ArrayList<>();
    if (!Sought.of(problem).isEmpty()) {
      sentences.add(
          "What nobody knows counts as found where it is looked for first; where it is likelier,"
              + " and what looking elsewhere would cost, is not in the PDDL.");
    }
    if (problem.operators().stream().anyMatch(operator -> !operator.price().exact())) {
      sentences.add(
          "Prices that only the member itself can reckon stand in the PDDL with what they are at"
              + " least.");
    }
    sentences.add(
        timed
            ? "What has to hold while a step goes on is asked only at its beginning."
            : "How long steps take, and which of them may go on at once, is not in the PDDL.");
    if (task.objective() != Objective.CHEAPEST) {
      sentences.add("The PDDL asks for the cheapest plan, not for the one that is over first.");
    }
    return sentences;
  }

  private void write(Operator operator) {
    List<String> words = new ArrayList<>();
    words.add(operator.feature().type().name());
    words.add(operator.feature().member());
    for (Term value : operator.bindings().values()) {
      words.add(SlPrinter.print(value));
    }
    String name = String.join("__", words);
    for (StepCases.Case one : new StepCases(operator, ranges, conditions, timed).all()) {
      List<String> effects = new ArrayList<>();
      one.allEffects().forEach((fact, holds) -> effects.add(literal(fact, holds)));
      one.increases()
          .forEach(
              (variable, amount) ->
                  effects.add("(increase %s %s)".formatted(function(variable), number(amount))));
      if (effects.isEmpty()) {
        continue;
      }
      String cost = "(increase (total-cost) %s)".formatted(number(one.cost()));
      if (timed) {
        process(operator, name, one, effects, cost);
      } else {
        effects.add(cost);
        action(name, one.condition(), effects);
      }
    }
  }

  private void process(
      Operator operator, String name, StepCases.Case one, List<String> effects, String cost) {
    String action = names.action(name);
    Clause.Fact runs = new Clause.Said("running " + action);
    String clock = names.clock(action);
    functions.add(clock);
    clocks.add(clock);
    List<Clause.Fact> taken = new ArrayList<>(List.of(runs));
    operator
        .feature()
        .type()
        .occupies()
        .forEach(
            part -> taken.add(new Clause.Said("busy " + operator.feature().member() + " " + part)));
    actions.append(
        "  (:action %s%n    :parameters ()%n    :precondition (and%s%s)%n    :effect (and %s (assign %s 0) %s))%n"
            .formatted(
                action,
                condition(one.condition()),
                literals(taken, false),
                literals(taken, true).strip(),
                clock,
                cost));
    actions.append(
        "  (:process goes-on__%s%n    :parameters ()%n    :precondition (and %s)%n    :effect (and (increase %s (* #t 1))))%n"
            .formatted(action, literal(runs, true), clock));
    actions.append(
        "  (:event ends__%s%n    :parameters ()%n    :precondition (and %s (>= %s %s))%n    :effect (and%s %s))%n"
            .formatted(
                action,
                literal(runs, true),
                clock,
                number(Math.max(0, one.seconds())),
                literals(taken, false),
                String.join(" ", effects)));
  }

  private String literals(List<Clause.Fact> facts, boolean hold) {
    return facts.stream().map(fact -> " " + literal(fact, hold)).collect(Collectors.joining());
  }

  private void action(String name, Clause condition, List<String> effects) {
    actions.append(
        "  (:action %s%n    :parameters ()%n    :precondition (and%s)%n    :effect (and %s))%n"
            .formatted(names.action(name), condition(condition), String.join(" ", effects)));
  }

  private String condition(Clause clause) {
    StringBuilder text = new StringBuilder();
    clause.facts().forEach((fact, holds) -> text.append(' ').append(literal(fact, holds)));
    for (Clause.Bound bound : clause.bounds()) {
      text.append(
          " (%s %s %s)"
              .formatted(bound.relation(), function(bound.variable()), number(bound.number())));
    }
    return text.toString();
  }

  private String literal(Clause.Fact fact, boolean holds) {
    return holds ? names.atom(fact) : "(not " + names.atom(fact) + ")";
  }

  private String function(NumberVariable variable) {
    String function = names.function(variable);
    functions.add(function);
    return function;
  }

  static String number(double value) {
    return BigDecimal.valueOf(value)
        .setScale(COST_PLACES, RoundingMode.HALF_EVEN)
        .stripTrailingZeros()
        .toPlainString();
  }

  private String goal() {
    List<Clause> clauses = conditions.clauses(problem.goal().condition());
    if (clauses.size() == 1) {
      return "(and" + condition(clauses.get(0)) + ")";
    }
    Clause.Fact reached = new Clause.Said("goal-reached");
    for (Clause clause : clauses) {
      action(
          "reach-the-goal", clause, List.of(literal(reached, true), "(increase (total-cost) 0)"));
    }
    return "(and " + names.atom(reached) + ")";
  }

  private String initially() {
    Map<Clause.Fact, Boolean> facts = new LinkedHashMap<>();
    for (Variable variable : problem.variables()) {
      int code = problem.initial().code(variable);
      for (int value = 0; value < variable.valueCount(); value++) {
        facts.put(new Clause.Is(variable, value), code == value);
        facts.put(new Clause.Open(variable, value), variable.isUnknown(code, value));
      }
    }
    StringBuilder text = new StringBuilder();
    for (NumberVariable variable : problem.numbers()) {
      if (ranges.isSum(variable)) {
        if (functions.contains(names.function(variable))) {
          text.append(
              "%n    (= %s %s)".formatted(names.function(variable), number(variable.initial())));
        }
      } else {
        facts.put(new Clause.Has(variable, variable.initial()), true);
      }
    }
    clocks.forEach(clock -> text.append("%n    (= %s 0)".formatted(clock)));
    Set<String> atoms = new TreeSet<>();
    facts.forEach(
        (fact, holds) -> {
          if (holds && names.isUsed(fact)) {
            atoms.add(names.atom(fact));
          }
        });
    atoms.forEach(atom -> text.append("\n    ").append(atom));
    return text.toString();
  }
}
