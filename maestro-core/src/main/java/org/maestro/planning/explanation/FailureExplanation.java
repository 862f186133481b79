package org.maestro.planning.explanation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.planning.api.Effort;
import org.maestro.planning.api.PlanningResult.Cure;
import org.maestro.planning.api.PlanningResult.Explanation;
import org.maestro.planning.api.PlanningResult.Obstacle;
import org.maestro.planning.api.PlanningResult.Obstacle.Kind;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.api.Unavailable;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.grounding.Returned;
import org.maestro.planning.optimal.NumberLimits;
import org.maestro.planning.optimal.RelaxedProblem;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.Condition.Question;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.sl.Facts;

/**
 * Why there is no plan: the least set of conditions with which there would be one, found by {@link
 * ExcuseSearch} and tried out by planning with them, and for each of them what else would do.
 *
 * <p>Numbers and stated facts that hamper are preferred to members that are not there, these to
 * what other features could change, and that to where things are seen to be. The goal itself comes
 * last: it is no explanation.
 */
public final class FailureExplanation {
  private static final int MOST_CURES = 4;
  private static final int MOST_ATTEMPTS = 4;

  /** A cure may weigh that much more than the condition that it stands for. */
  private static final double HEAVIER = 6;

  /** What other features could bring about, if it were not for something else. */
  private static final double CHANGEABLE = 8;

  /** Where things are and what can be seen: nobody's fault. */
  private static final double OBSERVABLE = 20;

  private static final double GOAL_ITSELF = 50;

  private final PlanningTask task;
  private final Predicate<PlanningTask> isSolvable;
  private final GroundProblem base;
  private final Map<Condition, Obstacle> obstacles = new LinkedHashMap<>();
  private final Map<Condition, Double> weights = new LinkedHashMap<>();
  private final ExcuseSearch search;
  private final NumberLimits limits;

  private FailureExplanation(
      PlanningTask task,
      PricedFeature anyFeature,
      int mostStates,
      Predicate<PlanningTask> isSolvable) {
    this.task = task;
    this.isSolvable = isSolvable;
    Facts facts = new Returned(task.facts(), task.vocabulary(), task.unavailable());
    this.base = Grounder.forExplanation(task.withFacts(facts)).ground();
    Set<Condition> leaves = leavesThatFail();
    List<Operator> toBeHad =
        base.operators().stream().filter(FailureExplanation::isToBeHad).toList();
    GroundProblem available = base.with(toBeHad);
    RelaxedProblem relaxed = new RelaxedProblem(available);
    if (!relaxed.isSolvable()) {
      leaves.removeAll(relaxed.reachableLeaves());
    }
    Set<Object> moved = moved(toBeHad);
    Set<Condition> ofGoal = new LinkedHashSet<>();
    base.goal().condition().forEachLeaf(ofGoal::add);
    for (Condition leaf : leaves) {
      if (mayBeAssumed(leaf)) {
        Obstacle obstacle = ObstacleText.obstacle(leaf, available, relaxed.settings(), moved);
        obstacles.put(leaf, obstacle);
        boolean isGoalItself = ofGoal.contains(leaf) && obstacle.kind() != Kind.NUMBER;
        weights.put(leaf, weight(leaf, obstacle) + (isGoalItself ? GOAL_ITSELF : 0));
      }
    }
    this.search = new ExcuseSearch(base, anyFeature, Effort.forBestPlan(mostStates));
    this.limits = new NumberLimits(base, toBeHad);
  }

  /**
   * The explanation for a task that has no plan.
   *
   * @param mostStates of each of the searches that this takes
   * @param isSolvable tells of another task whether it has a plan
   */
  public static Explanation of(
      PlanningTask task, int mostStates, Predicate<PlanningTask> isSolvable) {
    return Stream.concat(
            task.features().stream(), task.unavailable().stream().map(Unavailable::feature))
        .findFirst()
        .map(any -> new FailureExplanation(task, any, mostStates, isSolvable).explanation())
        .orElseGet(() -> theGoalItself(task));
  }

  private Set<Condition> leavesThatFail() {
    Set<Condition> leaves = new LinkedHashSet<>();
    base.goal().condition().forEachLeaf(leaves::add);
    base.operators().forEach(operator -> operator.precondition().forEachLeaf(leaves::add));
    leaves.removeIf(leaf -> leaf.holds(base.initial()));
    return leaves;
  }

  /** What the operators make more or less of; to measure it is not to move it. */
  private static Set<Object> moved(List<Operator> operators) {
    return operators.stream()
        .flatMap(operator -> operator.changes().stream())
        .filter(Change.Adjust.class::isInstance)
        .map(Change::target)
        .collect(Collectors.toSet());
  }

  /** Whether nothing forbids it for good. */
  private static boolean isToBeHad(Operator operator) {
    return operator.precondition().conjuncts().stream()
        .noneMatch(Condition.Fixed.class::isInstance);
  }

  /** That something were unknown is nothing to wish for. */
  private static boolean mayBeAssumed(Condition leaf) {
    return !(leaf instanceof Condition.NumberKnown number && !number.known()
        || leaf instanceof Condition.Literal literal && literal.question() == Question.UNKNOWN);
  }

  private static double weight(Condition leaf, Obstacle obstacle) {
    return switch (obstacle.kind()) {
      case NUMBER -> leaf instanceof Condition.Fixed ? 1.2 : 1;
      case STEP -> 1.1;
      case MEMBER -> 2.4;
      case FACT ->
          leaf instanceof Condition.Fixed
              ? 1.3
              : leaf instanceof Condition.Literal literal && literal.variable().observable()
                  ? 1.5 * OBSERVABLE
                  : CHANGEABLE;
      case EXCLUDED -> OBSERVABLE;
      case UNKNOWN -> 1.2 * OBSERVABLE;
      case GOAL -> GOAL_ITSELF;
    };
  }

  private Explanation explanation() {
    Map<Condition, Double> tried = new LinkedHashMap<>(weights);
    for (int attempt = 0; attempt < MOST_ATTEMPTS; attempt++) {
      if (!(search.run(tried, Set.of()) instanceof ExcuseSearch.Outcome.Found found)) {
        break;
      }
      List<Obstacle> named = named(found.neededBy());
      if (helps(named)) {
        return new Explanation(withCures(found.neededBy()), true);
      }
      found.neededBy().keySet().forEach(leaf -> tried.merge(leaf, OBSERVABLE, Double::sum));
    }
    return theGoalItself(task);
  }

  private static Explanation theGoalItself(PlanningTask task) {
    return new Explanation(List.of(ObstacleText.ofGoal(task)), false);
  }

  private List<Obstacle> named(Map<Condition, Optional<StepKey>> neededBy) {
    List<Obstacle> named = new ArrayList<>();
    neededBy.forEach((leaf, step) -> named.add(obstacle(leaf).neededBy(step)));
    return named;
  }

  /** Of a condition that may be assumed. */
  private Obstacle obstacle(Condition condition) {
    return Objects.requireNonNull(obstacles.get(condition));
  }

  private boolean helps(List<Obstacle> cured) {
    return isSolvable.test(Cures.applied(task, cured));
  }

  private List<Obstacle> withCures(Map<Condition, Optional<StepKey>> cited) {
    List<Obstacle> result = new ArrayList<>();
    for (Map.Entry<Condition, Optional<StepKey>> entry : cited.entrySet()) {
      Set<Condition> others = new LinkedHashSet<>(cited.keySet());
      others.remove(entry.getKey());
      result.add(
          limits
              .limited(obstacle(entry.getKey()), entry.getKey())
              .neededBy(entry.getValue())
              .withCures(cures(entry.getKey(), others)));
    }
    return List.copyOf(result);
  }

  /** What would do instead of the condition, the others being given. */
  private List<Cure> cures(Condition condition, Set<Condition> others) {
    Map<Condition, Double> open = new LinkedHashMap<>(weights);
    double weight = Objects.requireNonNull(open.remove(condition));
    open.keySet().removeAll(others);
    List<Cure> cures = new ArrayList<>();
    List<Obstacle> given = others.stream().map(this::obstacle).toList();
    for (int i = 0; i < MOST_CURES; i++) {
      if (!(search.run(open, others) instanceof ExcuseSearch.Outcome.Found found)) {
        break;
      }
      double total = found.neededBy().keySet().stream().mapToDouble(open::get).sum();
      if (total > weight + HEAVIER || found.neededBy().isEmpty()) {
        break;
      }
      List<Obstacle> named = named(found.neededBy());
      List<Obstacle> all = new ArrayList<>(given);
      all.addAll(named);
      if (helps(all)) {
        cures.add(new Cure(named));
      }
      found.neededBy().keySet().forEach(open::remove);
    }
    return List.copyOf(cures);
  }
}
