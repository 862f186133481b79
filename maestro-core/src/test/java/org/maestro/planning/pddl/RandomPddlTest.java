package org.maestro.planning.pddl;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.statistics.Statistics;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.Grounder;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.ground.GrowingTask;
import org.maestro.planning.search.AnytimePlanner;
import org.maestro.planning.search.Solution;
import org.maestro.planning.search.Solution.Verdict;

/**
 * Small random domains and problems in PDDL, with all that is understood of it: plans hold when
 * another reader runs them, and cost what trying everything costs.
 */
class RandomPddlTest {
  private static final int MOST_STATES = 1200;

  @Property(tries = 60)
  void costsWhatTryingEverythingCosts(@ForAll Random random) {
    Statistics.label("small enough to try everything")
        .collect(isSmall(random))
        .coverage(coverage -> coverage.check(true).percentage(share -> share >= 50));
  }

  /** A step that costs nothing was done after the goal was reached, and undid it. */
  @Example
  void nothingIsDoneAfterTheGoalIsReached() {
    assertThat(isSmall(new Random(306))).isTrue();
  }

  /** Whether everything could be tried; if so, the planner was right. */
  private static boolean isSmall(Random random) {
    String domain = domain(random);
    String problem = problem(random);
    Optional<BigDecimal> expected = new PlanExecutor(domain, problem).cheapest(MOST_STATES);
    if (expected.filter(cost -> cost.signum() < 0).isPresent()) {
      return false;
    }
    GrowingTask growing =
        Grounder.growing(PddlReader.parse("d", domain, "p", problem), GroundingBudget.endless());
    Solution solution =
        new AnytimePlanner(growing, 100_000_000, line -> {}).solve(GroundingBudget.endless());
    GroundTask task = growing.task();
    if (expected.isEmpty()) {
      assertThat(solution.verdict()).isEqualTo(Verdict.UNSOLVABLE);
      return true;
    }
    assertThat(solution.verdict()).isEqualTo(Verdict.OPTIMAL);
    List<String> steps =
        solution.operators().stream()
            .map(task.names()::operator)
            .filter(step -> !step.isEmpty())
            .toList();
    BigDecimal cost = new PlanExecutor(domain, problem).cost(steps);
    assertThat(cost).isEqualByComparingTo(expected.get());
    assertThat(BigDecimal.valueOf(solution.cost()))
        .isEqualByComparingTo(task.unit().multiply(cost));
    return true;
  }

  private static String domain(Random random) {
    StringBuilder text =
        new StringBuilder(
            """
            (define (domain random)
              (:types box robot - thing thing place - object)
              (:constants home - place)
              (:predicates (free ?r - robot) (holds ?r - robot ?b - box) (at ?t - thing ?p - place)
                (way ?p ?q - place) (clean ?p - place) (done))
              (:functions (total-cost) - number (far ?p ?q - place) - number (charge ?r - robot))
            """);
    text.append(
        action(
            random,
            "go",
            "?r - robot ?p ?q - place",
            "(at ?r ?p) (way ?p ?q)" + (random.nextBoolean() ? " (>= (charge ?r) 1)" : ""),
            "(not (at ?r ?p)) (at ?r ?q) (increase (total-cost) (far ?p ?q))"
                + (random.nextBoolean() ? " (decrease (charge ?r) 1)" : "")));
    text.append(
        action(
            random,
            "take",
            "?r - robot ?b - box ?p - place",
            "(at ?r ?p) (at ?b ?p) (free ?r)",
            "(not (free ?r)) (not (at ?b ?p)) (holds ?r ?b) (increase (total-cost) 2)"));
    text.append(
        action(
            random,
            "put",
            "?r - robot ?b - box ?p - place",
            "(at ?r ?p) (holds ?r ?b)",
            "(free ?r) (at ?b ?p) (not (holds ?r ?b)) (increase (total-cost) 1.5)"));
    text.append(
        action(
            random,
            "wipe",
            "?r - (either robot box) ?p - place",
            "(at ?r ?p) (not (clean ?p))",
            "(clean ?p) (increase (total-cost) 1)"));
    text.append(action(random, "end", "", "", "(done) (increase (total-cost) 1)"));
    return text.append(")").toString();
  }

  /** An action with now and then a further condition or effect, sensible or not. */
  private static String action(
      Random random, String name, String parameters, String condition, String effect) {
    StringBuilder conditions = new StringBuilder(condition);
    StringBuilder effects = new StringBuilder();
    List<String> conditionsToo = new ArrayList<>();
    conditionsToo.add("(exists (?x - box) (at ?x home))");
    conditionsToo.add("(exists (?x - place) (and (not (clean ?x)) (not (= ?x home))))");
    conditionsToo.add("(exists (?x - robot) (free ?x))");
    conditionsToo.add("(not (done))");
    conditionsToo.add("(or (done) (clean home))");
    conditionsToo.add("(imply (clean home) (not (done)))");
    conditionsToo.add("(forall (?x - box) (not (at ?x home)))");
    conditionsToo.add("(forall (?x - place) (imply (way home ?x) (clean ?x)))");
    conditionsToo.add("(not (exists (?x - place) (and (clean ?x) (way ?x home))))");
    conditionsToo.add("(not (and (done) (or (clean home) (way home home))))");
    List<String> effectsToo = new ArrayList<>(List.of("(done)", "(not (done))", "(clean home)"));
    effectsToo.add("(when (clean home) (done))");
    effectsToo.add("(when (not (done)) (increase (total-cost) 3))");
    effectsToo.add("(when (exists (?x - robot) (free ?x)) (and (clean home) (not (done))))");
    effectsToo.add("(forall (?x - place) (when (way home ?x) (not (clean ?x))))");
    effectsToo.add("(forall (?x - box) (when (at ?x home) (not (at ?x home))))");
    effectsToo.add("(forall (?x - place) (clean ?x))");
    if (parameters.contains("?p")) {
      conditionsToo.add("(clean ?p)");
      conditionsToo.add("(not (clean ?p))");
      conditionsToo.add("(not (= ?p home))");
      conditionsToo.add("(= ?p home)");
      conditionsToo.add("(or (clean ?p) (not (clean home)))");
      effectsToo.add("(forall (?x - box) (when (and (at ?x ?p) (not (done))) (not (clean ?p))))");
      effectsToo.add("(not (clean ?p))");
      effectsToo.add("(way ?p home)");
      effectsToo.add("(not (way home ?p))");
    }
    if (parameters.contains("?r - robot")) {
      conditionsToo.add("(< (charge ?r) 2)");
      effectsToo.add("(increase (charge ?r) 2)");
      effectsToo.add("(free ?r)");
    }
    for (int more = random.nextInt(3); more > 0; more--) {
      conditions.append(' ').append(conditionsToo.get(random.nextInt(conditionsToo.size())));
    }
    for (int more = random.nextInt(2); more > 0; more--) {
      effects.append(' ').append(effectsToo.get(random.nextInt(effectsToo.size())));
    }
    // Before the action's own: what is added wins over what is deleted, whatever comes first.
    return "  (:action %s :parameters (%s) :precondition (and %s) :effect (and%s %s))%n"
        .formatted(name, parameters, conditions, effects, effect);
  }

  private static String problem(Random random) {
    int places = 2 + random.nextInt(2);
    StringBuilder init =
        new StringBuilder("(= (total-cost) 0) (= (charge r1) 2) (= (charge r2) 1)");
    List<String> names = new ArrayList<>(List.of("home", "p1", "p2", "p3").subList(0, places + 1));
    for (String from : names) {
      for (String to : names) {
        init.append(" (= (far %s %s) %d)".formatted(from, to, random.nextInt(5)));
        if (random.nextInt(3) > 0) {
          init.append(" (way %s %s)".formatted(from, to));
        }
      }
      if (random.nextInt(3) == 0) {
        init.append(" (clean %s)".formatted(from));
      }
    }
    for (String thing : List.of("b1", "b2", "r1", "r2")) {
      init.append(" (at %s %s)".formatted(thing, names.get(random.nextInt(names.size()))));
    }
    init.append(" (free r1)").append(random.nextBoolean() ? " (free r2)" : "");
    List<String> wishes =
        List.of(
            "(at b1 home)",
            "(at b2 p1)",
            "(holds r1 b2)",
            "(clean p2)",
            "(not (clean home))",
            "(done)",
            "(exists (?x - box) (and (at ?x p1) (not (at ?x p2))))",
            "(>= (charge r1) 2)",
            "(not (free r1))",
            "(or (done) (clean p1))",
            "(imply (done) (clean home))",
            "(forall (?x - place) (imply (way home ?x) (clean ?x)))",
            "(forall (?x - place) (or (clean ?x) (at b1 ?x)))",
            "(not (or (clean home) (done)))");
    StringBuilder goal = new StringBuilder();
    for (int i = 1 + random.nextInt(2); i > 0; i--) {
      goal.append(' ').append(wishes.get(random.nextInt(wishes.size())));
    }
    return "(define (problem p) (:domain random) (:objects b1 b2 - box r1 r2 - robot %s - place) (:init %s) (:goal (and%s)) (:metric minimize (total-cost)))"
        .formatted(String.join(" ", List.of("p1", "p2", "p3")), init, goal);
  }
}
