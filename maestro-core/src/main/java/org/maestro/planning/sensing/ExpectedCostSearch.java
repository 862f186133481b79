package org.maestro.planning.sensing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlannedSearch;
import org.maestro.planning.api.PlannedSearch.Place;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.grounding.Chances;
import org.maestro.planning.optimal.RelaxedProblem;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.PlanBuilder;
import org.maestro.planning.problem.Sought;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.Variable;
import org.maestro.sl.Term;

/**
 * Chooses where to look first for what nobody knows, so that the whole goal is expected to cost
 * least: the plans that look first here, there and nowhere are weighed against each other, each
 * with the chance that the thing is not there and the search goes on.
 *
 * <p>A plan is optimistic: it counts on finding what it looks for. Its look costs {@code a}, with
 * all that has to be done before; what comes after it costs {@code r}; it finds the thing with
 * chance {@code p}. Then beginning with it is expected to cost {@code a + p r + (1 - p) V}, where
 * {@code V} is the expected cost of the rest of the search ({@link SearchOrder}).
 */
public final class ExpectedCostSearch {
  /** Plans made at most to weigh one search. */
  private static final int MOST_PLANS = 6;

  /** Of those that are not found; who cannot get at one place still may at the next. */
  private static final int MOST_IN_VAIN = 2;

  private static final double SAME = 1e-9;

  /** Finds a cheapest plan, if there is one within bounds. */
  public interface Solver {
    /**
     * @param supposed where what is sought is
     * @param problem over those steps that are of use then
     */
    Optional<List<Operator>> solve(MostLikelyState supposed, GroundProblem problem);
  }

  private record Candidate(List<Operator> operators, Plan plan) {}

  /** A plan split at a look: what has to be done for it, and what comes after it. */
  private record Split(List<StepKey> prefix, double look, double rest) {}

  private final GroundProblem problem;
  private final Chances chances;
  private final Solver solver;
  private final Map<Sought, Integer> choice = new LinkedHashMap<>();
  private final List<PlannedSearch> searches = new ArrayList<>();
  private Candidate best;
  private @Nullable RelaxedProblem relaxed;

  public ExpectedCostSearch(
      GroundProblem problem, Chances chances, Solver solver, List<Operator> optimistic) {
    this.problem = problem;
    this.chances = chances;
    this.solver = solver;
    this.best = new Candidate(optimistic, PlanBuilder.plan(problem.placed(), optimistic));
    for (Sought sought : Sought.of(problem)) {
      int first = sought.firstLookedAt(optimistic);
      if (first >= 0) {
        choice.put(sought, first);
      }
    }
  }

  /** The plan to begin with; the optimistic one where there is nothing to choose. */
  public Plan plan() {
    // To weigh one changes where the others begin, but not which there are.
    for (Map.Entry<Sought, Integer> chosen : choice.entrySet()) {
      if (chosen.getValue() >= 0) {
        weigh(chosen.getKey(), chosen.getValue());
      }
    }
    return best.plan().withSearches(searches);
  }

  /**
   * Finds the best beginning of one search, while the others begin as chosen. Places are weighed by
   * estimated costs at first; a plan is made for the likeliest of them and for the best, and they
   * are weighed again, until the best one has a plan.
   *
   * @param chosen where it begins as yet
   */
  private void weigh(Sought sought, int chosen) {
    int present = sought.values().indexOf(chosen);
    LookCosts costs = new LookCosts(problem.placed(), relaxed(), sought);
    boolean avoidable = costs.isInReachWithoutLooks();
    Map<Term, Double> chanceOf = chances.of(sought.variable(), sought.terms());
    double[] chance = shares(sought, chanceOf);
    double[] look = costs.looks(costs.initial());
    Map<Integer, Candidate> candidates = new TreeMap<>();
    Map<Integer, Split> splits = new TreeMap<>();
    candidates.put(present, best);
    splits.put(present, split(best, sought, chosen).orElseThrow());
    Set<Integer> open = new TreeSet<>();
    for (int i = 0; i < look.length; i++) {
      if (i != present && Double.isFinite(look[i])) {
        open.add(i);
      }
    }
    int likeliest = likeliest(present, chance, open);
    if (likeliest != present) {
      plan(sought, likeliest, open, candidates, splits);
    }
    Rests rests = new Rests(new State[look.length], new double[look.length]);
    double[] expected = expectedCosts(costs, present, chance, look, splits, rests);
    int first = least(expected, chance, present, candidates.keySet(), open);
    int inVain = 0;
    for (int plans = 1; !candidates.containsKey(first); plans++) {
      boolean without = plan(sought, first, open, candidates, splits);
      inVain += candidates.containsKey(first) ? 0 : 1;
      // What is cheaper without it here is so for the like places that the estimates favour next.
      if (without || inVain == MOST_IN_VAIN || plans == MOST_PLANS) {
        open.clear();
      }
      expected = expectedCosts(costs, present, chance, look, splits, rests);
      first = least(expected, chance, present, candidates.keySet(), open);
    }
    Optional<Candidate> without = avoidable ? candidate(sought, Variable.NONE) : Optional.empty();
    if (without.isPresent() && without.get().plan().cost() < expected[first] - SAME) {
      choose(without.get());
      return;
    }
    choose(candidates.get(first));
    searches.add(described(sought, first, chanceOf, expected, look, splits));
  }

  /**
   * Makes the plan that begins with this place, if there is one.
   *
   * @return whether the cheapest plan for it there does without what is sought
   */
  private boolean plan(
      Sought sought,
      int place,
      Set<Integer> open,
      Map<Integer, Candidate> candidates,
      Map<Integer, Split> splits) {
    open.remove(place);
    int value = sought.values().get(place);
    Optional<Candidate> found = candidate(sought, value);
    Optional<Split> split = found.flatMap(plan -> split(plan, sought, value));
    split.ifPresent(
        looks -> {
          candidates.put(place, found.orElseThrow());
          splits.put(place, looks);
        });
    return found.isPresent() && split.isEmpty();
  }

  /** Estimates are not to decide against the place where most would look first. */
  private static int likeliest(int present, double[] chance, Set<Integer> open) {
    int likeliest = present;
    for (int place : open) {
      likeliest = chance[place] > chance[likeliest] + SAME ? place : likeliest;
    }
    return likeliest;
  }

  /** The chances of what can be looked at, as if there were nothing else. */
  private static double[] shares(Sought sought, Map<Term, Double> chanceOf) {
    double[] chance = sought.terms().stream().mapToDouble(term -> chance(term, chanceOf)).toArray();
    double sum = Arrays.stream(chance).sum();
    return Arrays.stream(chance).map(one -> sum > 0 ? one / sum : 1.0 / chance.length).toArray();
  }

  /** What can be looked at is never excluded, so that it has a chance. */
  private static double chance(Term inView, Map<Term, Double> chanceOf) {
    return Objects.requireNonNull(chanceOf.get(inView));
  }

  /** Among equals the likeliest; among those the present choice, then what has a plan. */
  private static int least(
      double[] expected, double[] chance, int present, Set<Integer> planned, Set<Integer> open) {
    int least = present;
    for (Set<Integer> places : List.of(planned, open)) {
      for (int i : places) {
        double more = expected[i] - expected[least];
        boolean isLikelier = chance[i] > chance[least] + SAME;
        least = more < -SAME || more <= SAME && isLikelier ? i : least;
      }
    }
    return least;
  }

  private void choose(Candidate candidate) {
    best = candidate;
    choice.replaceAll((sought, before) -> sought.firstLookedAt(candidate.operators()));
  }

  /** The problem's variables are placed for it. */
  private RelaxedProblem relaxed() {
    if (relaxed == null) {
      relaxed = new RelaxedProblem(problem);
    }
    return relaxed;
  }

  /**
   * The rest of the plan after each look, as far as it is estimated by now.
   *
   * @param after the state after a successful look; null where none is estimated yet
   * @param rest the cost from there on
   */
  private record Rests(@Nullable State[] after, double[] rest) {
    void estimate(LookCosts costs, int place, @Nullable Split split) {
      if (split != null) {
        after[place] = costs.after(split.prefix());
        rest[place] = costs.rest(costs.initial(), after[place], place).cost();
      } else if (after[place] == null) {
        after[place] = costs.initial();
        rest[place] = costs.restAtOnce(place).cost();
      }
    }
  }

  /** For each place; where no plan was made, by the estimated costs. */
  private double[] expectedCosts(
      LookCosts costs,
      int present,
      double[] chance,
      double[] look,
      Map<Integer, Split> splits,
      Rests rests) {
    problem.placed();
    int size = look.length;
    for (int i = 0; i < size; i++) {
      rests.estimate(costs, i, splits.get(i));
    }
    State[] after = rests.after();
    double[] rest = rests.rest();
    double restAtPresent = Objects.requireNonNull(splits.get(present)).rest();
    SearchOrder.Cost[] first = new SearchOrder.Cost[size];
    for (int i = 0; i < size; i++) {
      first[i] =
          splits.containsKey(i)
              ? new SearchOrder.Cost(splits.get(i).look(), splits.get(i).rest())
              : new SearchOrder.Cost(look[i], changed(restAtPresent, rest[present], rest[i]));
    }
    if (costs.sought().isInManyPlaces()) {
      SearchOrder order = new SearchOrder(chance, first);
      return IntStream.range(0, size).mapToDouble(order::expectedCost).toArray();
    }
    SearchOrder.Cost[][] next = new SearchOrder.Cost[size][];
    for (int i = 0; i < size; i++) {
      next[i] = first.clone();
      if (splits.containsKey(i)) {
        double[] looks = costs.looksAfterVainLook(after[i], i);
        for (int j = 0; j < size; j++) {
          next[i][j] =
              new SearchOrder.Cost(
                  changed(first[j].look(), look[j], looks[j]),
                  changed(first[j].rest(), rest[j], costs.rest(after[i], after[j], j).cost()));
        }
      }
    }
    SearchOrder order = new SearchOrder(chance, first, next);
    return IntStream.range(0, size).mapToDouble(order::expectedCost).toArray();
  }

  /** The exact cost, changed as the estimated one changes. */
  private static double changed(double exact, double before, double after) {
    double change = after - before;
    return Double.isFinite(change) ? Math.max(0, exact + change) : exact;
  }

  private static PlannedSearch described(
      Sought sought,
      int first,
      Map<Term, Double> chanceOf,
      double[] expected,
      double[] look,
      Map<Integer, Split> splits) {
    List<Term> terms = sought.terms();
    List<Place> places = new ArrayList<>();
    IntStream.range(0, look.length)
        .boxed()
        .sorted(
            Comparator.<Integer>comparingInt(i -> i == first ? 0 : 1)
                .thenComparingDouble(i -> expected[i]))
        .forEach(
            i ->
                places.add(
                    new Place(
                        terms.get(i),
                        chance(terms.get(i), chanceOf),
                        splits.containsKey(i) ? splits.get(i).look() : look[i],
                        expected[i])));
    chanceOf.forEach(
        (value, chance) -> {
          if (!terms.contains(value)) {
            places.add(
                new Place(value, chance, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY));
          }
        });
    return new PlannedSearch(sought.variable().predicate(), sought.variable().arguments(), places);
  }

  /**
   * The cheapest plan that finds the sought at this value if at all, and what else is sought as
   * chosen.
   */
  private Optional<Candidate> candidate(Sought sought, int value) {
    Map<Sought, Integer> chosen = new LinkedHashMap<>(choice);
    chosen.put(sought, value);
    return candidate(chosen);
  }

  private Optional<Candidate> candidate(Map<Sought, Integer> chosen) {
    MostLikelyState supposed = new MostLikelyState(chosen);
    GroundProblem smaller = supposed.appliedTo(problem);
    return solver
        .solve(supposed, smaller)
        .map(found -> new Candidate(found, PlanBuilder.plan(smaller.placed(), found)));
  }

  /** Empty when the plan does not look there. */
  private Optional<Split> split(Candidate candidate, Sought sought, int value) {
    List<Operator> operators = candidate.operators();
    for (int at = 0; at < operators.size(); at++) {
      if (sought.looksAt(operators.get(at), value)) {
        Set<Integer> ofOthers = new HashSet<>();
        for (int before = 0; before < at; before++) {
          if (isOfOther(operators.get(before), sought)) {
            ofOthers.add(before + 1);
          }
        }
        return Optional.of(split(candidate.plan(), at + 1, ofOthers));
      }
    }
    return Optional.empty();
  }

  /** Whether it looks for something else, which has to be found wherever this is. */
  private boolean isOfOther(Operator operator, Sought sought) {
    return choice.keySet().stream()
            .filter(other -> !other.equals(sought))
            .anyMatch(other -> other.lookedAt(operator).findAny().isPresent())
        && sought.lookedAt(operator).findAny().isEmpty();
  }

  /**
   * @param ofOthers numbers of looks that are no part of this one, though a camera that looks for
   *     two things does so one after the other
   */
  private static Split split(Plan plan, int look, Set<Integer> ofOthers) {
    Set<Integer> before = new HashSet<>(Set.of(look));
    for (int number = look; number >= 1; number--) {
      if (before.contains(number)) {
        before.addAll(plan.steps().get(number - 1).after());
      }
    }
    List<StepKey> prefix = new ArrayList<>();
    double cost = 0;
    for (Step step : plan.steps()) {
      if (before.contains(step.number()) && !ofOthers.contains(step.number())) {
        prefix.add(step.key());
        cost += step.cost();
      }
    }
    return new Split(prefix, cost, plan.cost() - cost);
  }
}
