package org.maestro.planning;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.maestro.planning.SearchHomes.SearchHome;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * Carries searches out in a pretended home, in every way in which they may turn out, and tells what
 * they cost in the mean over where the things may be. After each look it is planned again.
 */
final class SearchPolicy {
  private final OptimalPlanner planner = new OptimalPlanner();
  private final SearchHome home;
  private final Map<String, Double> trueLux;
  private final Map<String, Double> bestKnown = new HashMap<>();
  private final Map<String, Double> plannersKnown = new HashMap<>();
  private final Map<String, Double> optimistsKnown = new HashMap<>();

  /**
   * @param trueLux the light of zones in which nobody knows it
   */
  SearchPolicy(SearchHome home, Map<String, Double> trueLux) {
    this.home = home;
    this.trueLux = trueLux;
  }

  /** What the planner's own choices cost in the mean; empty when it sees no way at all. */
  Optional<Double> ofPlanner() {
    double cost = of(planner::plan, plannersKnown, home.world());
    return Double.isNaN(cost) ? Optional.empty() : Optional.of(cost);
  }

  /** What it costs to look always where the whole plan is the cheapest if all is found there. */
  double ofOptimist() {
    return of(planner::optimistic, optimistsKnown, home.world());
  }

  private double of(
      Function<PlanningTask, PlanningResult> chosen, Map<String, Double> costs, SmallWorld world) {
    Double known = costs.get(world.situation());
    if (known == null) {
      known =
          chosen.apply(world.task(home.goal())) instanceof PlanningResult.Found found
              ? played(world, found.plan(), next -> of(chosen, costs, next))
              : Double.NaN;
      costs.put(world.situation(), known);
    }
    return known;
  }

  /** What the best of all orders costs in the mean: every look is tried as the next one. */
  double ofBestOrder() {
    return ofBestOrder(home.world());
  }

  private double ofBestOrder(SmallWorld world) {
    Double known = bestKnown.get(world.situation());
    if (known != null) {
      return known;
    }
    double best = Double.NaN;
    for (Set<StepKey> barred : choices(world)) {
      PlanningTask task = world.task(home.goal());
      PlanningResult result =
          planner.optimistic(
              new PlanningTask(
                  task.vocabulary(), task.facts(), task.features(), task.goal(), barred));
      if (result instanceof PlanningResult.Found found) {
        double cost = played(world, found.plan(), this::ofBestOrder);
        best = Double.isNaN(best) || cost < best ? cost : best;
      }
    }
    bestKnown.put(world.situation(), best);
    return best;
  }

  /** For each combination of places where the things might be looked for, all other looks. */
  private List<Set<StepKey>> choices(SmallWorld world) {
    List<Set<StepKey>> choices = new ArrayList<>(List.of(Set.of()));
    for (String thing : home.sought()) {
      List<Set<StepKey>> longer = new ArrayList<>();
      for (Set<StepKey> before : choices) {
        List<String> open = home.zones().stream().filter(z -> isOpen(world, thing, z)).toList();
        for (String zone : open) {
          Set<StepKey> barred = new HashSet<>(before);
          open.stream()
              .filter(other -> !other.equals(zone))
              .forEach(other -> barred.addAll(looks(world, thing, other)));
          longer.add(barred);
        }
        if (open.isEmpty()) {
          longer.add(before);
        }
      }
      choices = longer;
    }
    return choices;
  }

  private static List<StepKey> looks(SmallWorld world, String thing, String zone) {
    return world.offers.stream()
        .filter(offer -> isLook(offer.type().name()))
        .map(
            offer ->
                new StepKey(
                    offer.member(),
                    offer.type().name(),
                    Map.of("object", new Term.Name(thing), "zone", new Term.Name(zone))))
        .toList();
  }

  private static boolean isLook(String feature) {
    return feature.equals("observeObject") || feature.equals("lookAround");
  }

  private interface Further {
    double cost(SmallWorld world);
  }

  /** Carries out what the plan's first uncertain step needs, then that, then what the plans are. */
  private double played(SmallWorld world, Plan plan, Further further) {
    Optional<Step> uncertain =
        plan.steps().stream().filter(step -> isUncertain(world, step)).findFirst();
    if (uncertain.isEmpty()) {
      return plan.cost();
    }
    Set<Integer> needed = new HashSet<>(Set.of(uncertain.get().number()));
    for (int number = uncertain.get().number(); number > 0; number--) {
      if (needed.contains(number)) {
        needed.addAll(plan.steps().get(number - 1).after());
      }
    }
    SmallWorld next = world.copy();
    double cost = 0;
    for (Step step : plan.steps()) {
      if (needed.contains(step.number())) {
        cost += step.cost();
        carryOut(next, step);
      }
    }
    return cost
        + (isLook(uncertain.get().feature().name())
            ? afterLook(next, uncertain.get(), further)
            : further.cost(next));
  }

  private boolean isUncertain(SmallWorld world, Step step) {
    return step.feature().name().equals("measureIllumination")
        || isLook(step.feature().name()) && isOpen(world, text(step, "object"), text(step, "zone"));
  }

  private double afterLook(SmallWorld world, Step look, Further further) {
    String thing = text(look, "object");
    String zone = text(look, "zone");
    double chance = chance(world, thing, zone);
    double cost = chance * further.cost(world.copy().facts("(in " + thing + " " + zone + ")"));
    if (chance < 1 - 1e-9) {
      double missed = further.cost(world.copy().facts("(not (in " + thing + " " + zone + "))"));
      cost += (1 - chance) * missed;
    }
    return cost;
  }

  private void carryOut(SmallWorld world, Step step) {
    String member = step.member();
    switch (step.feature().name()) {
      case "move" -> world.facts("(in " + member + " " + text(step, "to") + ")");
      case "measureIllumination" -> {
        String zone = text(step, "zone");
        world.facts("(= (illuminance " + zone + ") " + trueLux.get(zone) + ")");
      }
      case "adjustLight" -> {
        double level = ((Term.Number) step.bindings().get("level")).value();
        double before = number(world, "level", member);
        world.facts("(= (level " + member + ") " + level + ")");
        for (String zone : home.zones()) {
          double gain = number(world, "gain", member, zone);
          double lux = number(world, "illuminance", zone);
          if (!Double.isNaN(gain) && !Double.isNaN(lux)) {
            world.facts("(= (illuminance " + zone + ") " + (lux + gain * (level - before)) + ")");
          }
        }
      }
      default -> {
        // a look, whose result is told apart
      }
    }
  }

  private static double number(SmallWorld world, String name, String... arguments) {
    List<Term> terms = new ArrayList<>();
    List.of(arguments).forEach(argument -> terms.add(new Term.Name(argument)));
    return world.number(new Expression.Fluent(name, terms)).orElse(Double.NaN);
  }

  private static boolean isOpen(SmallWorld world, String thing, String zone) {
    return truth(world, "in", thing, zone) == Truth.UNKNOWN;
  }

  private static Truth truth(SmallWorld world, String predicate, String... arguments) {
    List<Term> terms = new ArrayList<>();
    List.of(arguments).forEach(argument -> terms.add(new Term.Name(argument)));
    return world.truth(new Formula.Atom(predicate, terms));
  }

  /** By the prior that is documented: four fifths where it usually is, the rest by floor area. */
  private double chance(SmallWorld world, String thing, String zone) {
    double all = 0;
    for (String other : home.zones()) {
      if (isOpen(world, thing, other) && canBeLookedAt(world, other)) {
        all += prior(world, thing, other);
      }
    }
    return prior(world, thing, zone) / all;
  }

  private double prior(SmallWorld world, String thing, String zone) {
    boolean anywhere =
        home.zones().stream().noneMatch(z -> truth(world, "usuallyIn", thing, z) == Truth.TRUE);
    if (truth(world, "usuallyIn", thing, zone) == Truth.TRUE) {
      return 0.8;
    }
    double others = 0;
    for (String other : home.zones()) {
      others +=
          truth(world, "usuallyIn", thing, other) == Truth.TRUE
              ? 0
              : number(world, "floorArea", other);
    }
    return (anywhere ? 1 : 0.2) * number(world, "floorArea", zone) / others;
  }

  /** What no look reaches is in no order, whatever its chance. */
  private static boolean canBeLookedAt(SmallWorld world, String zone) {
    double lux = number(world, "illuminance", zone);
    boolean sensed = truth(world, "senses", "lux" + zone.substring(4), zone) == Truth.TRUE;
    double gain = number(world, "gain", "lamp" + zone.substring(4), zone);
    boolean lit = Double.isNaN(lux) ? sensed : lux >= 72 || lux + (gain > 0 ? gain : 0) >= 72;
    boolean seen =
        truth(world, "covers", "cam" + zone.substring(4), zone) == Truth.TRUE
            || world.offers.stream().anyMatch(offer -> offer.type().name().equals("lookAround"));
    return lit && seen;
  }

  private static String text(Step step, String name) {
    return SlPrinter.print(step.bindings().get(name));
  }
}
