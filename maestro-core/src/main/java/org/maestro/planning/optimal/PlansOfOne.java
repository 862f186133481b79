package org.maestro.planning.optimal;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.maestro.planning.api.Effort;
import org.maestro.planning.api.OpenPrice;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.PlanBuilder;

/**
 * Plans in which one of many like members does what they all could do, with whoever is not like
 * them. That no two of them do it better together takes very long to prove where they are many, and
 * is seldom otherwise.
 */
public final class PlansOfOne {
  private static final int MOST_PLANS = 8;

  /** Lower bounds that do not lead to a plan cost time. */
  private static final int MOST_TRIED = 16;

  /** What is left when one does it. */
  private record Alone(GroundProblem problem, LandmarkCut cuts, double atLeast) {}

  private final GroundProblem problem;
  private final List<PricedFeature> features;
  private final int mostStates;

  /**
   * @param features of all members
   * @param mostStates kept at once by one search
   */
  public PlansOfOne(GroundProblem problem, List<PricedFeature> features, int mostStates) {
    this.problem = problem;
    this.features = features;
    this.mostStates = mostStates;
  }

  /**
   * The cheapest of those found soon, with the open prices of the others as rivals; empty where
   * there are no members alike, or one cannot do it. The problem's variables are placed for it.
   *
   * @param atLeast what no plan is below
   */
  public Optional<PlanningResult.Found> cheapest(double atLeast) {
    List<Plan> plans = plans();
    if (plans.isEmpty()) {
      return Optional.empty();
    }
    Plan cheapest = plans.get(0);
    Set<String> contenders = new LinkedHashSet<>();
    plans.forEach(plan -> contenders.addAll(plan.members()));
    return Optional.of(
        new PlanningResult.Found(
            cheapest,
            OptionalDouble.of(Math.min(atLeast, cheapest.cost())),
            contenders,
            openPrices(plans.subList(1, plans.size()))));
  }

  private static List<OpenPrice> openPrices(List<Plan> plans) {
    return plans.stream()
        .flatMap(plan -> plan.steps().stream())
        .filter(step -> !step.exactPrice())
        .map(step -> new OpenPrice(step.key(), step.feature(), step.cost(), step.seconds()))
        .distinct()
        .toList();
  }

  /** The cheapest first. */
  private List<Plan> plans() {
    List<Plan> plans = new ArrayList<>();
    double best = Double.POSITIVE_INFINITY;
    List<Alone> tried = likeliest();
    for (Alone alone : tried.subList(0, Math.min(MOST_TRIED, tried.size()))) {
      if (plans.size() >= MOST_PLANS && alone.atLeast() >= best) {
        break;
      }
      OptimalSearch search =
          new OptimalSearch(
              alone.problem().placed(),
              alone.cuts(),
              Effort.forSoonFoundPlan(mostStates),
              Double.POSITIVE_INFINITY);
      if (search.run() instanceof OptimalSearch.Outcome.Found found) {
        Plan plan = PlanBuilder.plan(alone.problem(), found.operators());
        plans.add(plan);
        best = Math.min(best, plan.cost());
      }
    }
    problem.placed();
    plans.sort(Comparator.comparingDouble(Plan::cost));
    return plans;
  }

  /** By what their plans cost at least. */
  private List<Alone> likeliest() {
    List<Alone> likeliest = new ArrayList<>();
    Set<String> alike = alike();
    for (String member : alike) {
      GroundProblem alone = problem.with(without(alike, member)).placed();
      RelaxedProblem relaxed = new RelaxedProblem(alone);
      if (relaxed.isSolvable()) {
        LandmarkCut cuts = new LandmarkCut(relaxed);
        likeliest.add(new Alone(alone, cuts, cuts.estimate(alone.initial())));
      }
    }
    likeliest.sort(Comparator.comparingDouble(Alone::atLeast));
    return likeliest;
  }

  private List<Operator> without(Set<String> alike, String member) {
    return problem.operators().stream()
        .filter(
            operator -> {
              String whose = operator.feature().member();
              return whose.equals(member) || !alike.contains(whose);
            })
        .toList();
  }

  /** Of those who can do the same, the ones who have most operators. */
  private Set<String> alike() {
    Map<String, Long> operatorsOf =
        problem.operators().stream()
            .collect(Collectors.groupingBy(o -> o.feature().member(), Collectors.counting()));
    Map<String, Set<String>> featuresOf = new TreeMap<>();
    for (PricedFeature feature : features) {
      if (operatorsOf.containsKey(feature.member())) {
        featuresOf
            .computeIfAbsent(feature.member(), absent -> new TreeSet<>())
            .add(feature.type().name());
      }
    }
    return featuresOf.keySet().stream()
        .collect(Collectors.groupingBy(featuresOf::get, Collectors.toCollection(TreeSet::new)))
        .values()
        .stream()
        .filter(members -> members.size() > 1)
        .max(Comparator.comparingLong(all -> all.stream().mapToLong(operatorsOf::get).sum()))
        .orElseGet(TreeSet::new);
  }
}
