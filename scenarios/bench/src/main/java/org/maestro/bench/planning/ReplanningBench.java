package org.maestro.bench.planning;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.maestro.bench.BenchReport;
import org.maestro.bench.LargeHome;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.ontology.home.Home;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.ReplanningPlanner;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The time in which the platform's planner has a plan again when one agent left: in a home of many
 * like rooms where it is known how bright it is and where everything is, a thing is to be brought
 * two rooms farther. The baseline is the first time, of a planner that knows nothing yet; Java is
 * warm for both.
 */
final class ReplanningBench {
  private static final int[] ROOMS = {2, 16, 40};
  private static final int LEAVING = 11;
  private static final int WARM_UP = 3;

  private final Consumer<String> progress;

  ReplanningBench(Consumer<String> progress) {
    this.progress = progress;
  }

  List<BenchReport.Row> rows() {
    List<BenchReport.Row> rows = new ArrayList<>();
    for (int rooms : ROOMS) {
      LargeHome large = new LargeHome(rooms, rooms, 2).withStatedPrices();
      Home home = large.home();
      progress.accept("replanning, %d agents".formatted(home.devices().size()));
      measure(task(large, home), home.devices().size(), rows);
    }
    return rows;
  }

  private static PlanningTask task(LargeHome large, Home home) {
    List<PricedFeature> features =
        home.devices().values().stream()
            .flatMap(
                device ->
                    device.features().stream()
                        .map(type -> new PricedFeature(device.id(), type, type.cost(), Map.of())))
            .toList();
    int rooms = large.rooms();
    String goal =
        "(nextTo %s %s)".formatted(large.thing(0, 0), large.person(Math.min(2, rooms - 1)));
    try (CollectiveKnowledge knowledge = new CollectiveKnowledge(home, new SteppedClock())) {
      return new PlanningTask(
          home.vocabulary(),
          new AllSeen(knowledge.snapshot(), places(large)),
          features,
          SlParser.formula(goal),
          Set.of());
    }
  }

  private static Map<String, String> places(LargeHome large) {
    Map<String, String> places = new HashMap<>();
    for (int room = 0; room < large.rooms(); room++) {
      places.put(large.person(room), large.zone(room));
      places.put("robot-" + room, large.zone(room));
      for (int thing = 0; thing < large.thingsPerRoom(); thing++) {
        places.put(large.thing(room, thing), large.zone(room));
      }
    }
    return places;
  }

  private void measure(PlanningTask task, int agents, List<BenchReport.Row> rows) {
    List<Double> first = new ArrayList<>();
    Optional<Plan> plan = Optional.empty();
    for (int run = 0; run < 2 * WARM_UP; run++) {
      ReplanningPlanner planner = new ReplanningPlanner(new OptimalPlanner());
      long start = System.nanoTime();
      PlanningResult result = planner.solve(task);
      first.add(milliseconds(start));
      if (!(result instanceof PlanningResult.Found found)) {
        throw new IllegalStateException("The home of the benchmark has no plan: " + result);
      }
      plan = Optional.of(found.plan());
    }
    double baseline = median(first.subList(WARM_UP, first.size()));
    rows.add(
        BenchReport.Row.of("%d agents, platform's first plan".formatted(agents), baseline, "ms"));
    List<String> all =
        new ArrayList<>(
            new TreeSet<>(task.features().stream().map(PricedFeature::member).toList()));
    Collections.shuffle(all, new Random(1));
    again(agents, "any agent", all.subList(0, Math.min(LEAVING, all.size())), task, baseline, rows);
    again(
        agents,
        "one of the plan's",
        List.copyOf(plan.orElseThrow().members()),
        task,
        baseline,
        rows);
    joined(agents, all.subList(0, Math.min(LEAVING, all.size())), task, baseline, rows);
  }

  private static PlanningTask without(String member, PlanningTask task) {
    return task.withFeatures(
        task.features().stream().filter(f -> !f.member().equals(member)).toList());
  }

  /** Each comes to a home that was planned for without it. */
  private static void joined(
      int agents,
      List<String> joining,
      PlanningTask task,
      double baseline,
      List<BenchReport.Row> rows) {
    List<Double> times = new ArrayList<>();
    for (int run = 0; run <= WARM_UP; run++) {
      times.clear();
      for (String member : joining) {
        ReplanningPlanner planner = new ReplanningPlanner(new OptimalPlanner());
        planner.solve(without(member, task));
        long start = System.nanoTime();
        planner.solve(task);
        times.add(milliseconds(start));
      }
    }
    rows.add(
        new BenchReport.Row(
            String.format(Locale.ROOT, "%d agents, again after any agent joined, median", agents),
            median(times),
            "ms",
            OptionalDouble.of(baseline)));
  }

  private static void again(
      int agents,
      String who,
      List<String> leaving,
      PlanningTask task,
      double baseline,
      List<BenchReport.Row> rows) {
    List<Double> times = new ArrayList<>();
    for (int run = 0; run <= WARM_UP; run++) {
      times.clear();
      for (String member : leaving) {
        ReplanningPlanner planner = new ReplanningPlanner(new OptimalPlanner());
        planner.solve(task);
        PlanningTask without = without(member, task);
        long start = System.nanoTime();
        planner.solve(without);
        times.add(milliseconds(start));
      }
    }
    rows.add(
        new BenchReport.Row(
            String.format(Locale.ROOT, "%d agents, again after %s left, median", agents, who),
            median(times),
            "ms",
            OptionalDouble.of(baseline)));
  }

  private static double milliseconds(long since) {
    return (System.nanoTime() - since) / 1e6;
  }

  private static double median(List<Double> values) {
    List<Double> sorted = values.stream().sorted().toList();
    return sorted.get(sorted.size() / 2);
  }

  /**
   * The facts that stand in the home, with the places of all things, and with light in every other
   * room.
   */
  private record AllSeen(Facts described, Map<String, String> places) implements Facts {
    @Override
    public Truth truth(Formula.Atom atom) {
      String place =
          atom.predicate().equals("in") && atom.arguments().get(0) instanceof Term.Name thing
              ? places.getOrDefault(thing.text(), "")
              : "";
      return place.isEmpty()
          ? described.truth(atom)
          : Truth.of(atom.arguments().get(1).equals(new Term.Name(place)));
    }

    @Override
    public OptionalDouble number(Expression.Fluent fluent) {
      if (fluent.name().equals("illuminance")) {
        return OptionalDouble.of(isLight(fluent.arguments().get(0)) ? 100 : 17);
      }
      return fluent.name().equals("level") ? OptionalDouble.of(0) : described.number(fluent);
    }

    private static boolean isLight(Term zone) {
      return zone instanceof Term.Name name && name.text().hashCode() % 2 == 0;
    }

    @Override
    public Collection<Term.Name> individuals(String className) {
      return described.individuals(className);
    }
  }
}
