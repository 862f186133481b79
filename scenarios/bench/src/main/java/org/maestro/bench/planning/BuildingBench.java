package org.maestro.bench.planning;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.maestro.bench.BenchReport;
import org.maestro.bench.TemporaryDirectory;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.random.Building;

/**
 * Buildings from a household's size to that of an office tower: how long their homes take to load,
 * how long a person waits for a plan in them when nobody knows where things are, with a cold start
 * and the loading included, and how long a running platform takes to decide. A kind of goal that
 * takes longer than a minute is not tried in larger buildings.
 */
public final class BuildingBench {
  /** As many devices, about. */
  public static final List<Integer> DEVICES = List.of(40, 100, 200, 400, 1_000, 4_000);

  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final int DEVICES_PER_FLOOR = 400;
  private static final int WARM_LOADS = 3;
  private static final long SEED = 1;

  /** Different ones of each kind. */
  private static final int GOALS = 12;

  private final List<Integer> devices;
  private final Consumer<String> progress;
  private final List<BenchReport.Row> rows = new ArrayList<>();
  private final Set<Wish> tooSlow = EnumSet.noneOf(Wish.class);

  /** What is asked for. */
  private enum Wish {
    FETCH("a thing fetched for somebody") {
      @Override
      String goal(Building building, int number) {
        return "(nextTo Thing%d Person%d)"
            .formatted(number % building.things(), number % building.persons());
      }
    },
    LIGHT("a room lit") {
      @Override
      String goal(Building building, int number) {
        return "(>= (illuminance z%d) 200)"
            .formatted((building.rooms() / 2 + number) % building.rooms());
      }
    },
    LOOK("a thing in view") {
      @Override
      String goal(Building building, int number) {
        return "(canSee ?agent Thing%d)".formatted((1 + number) % building.things());
      }
    };

    private final String words;

    Wish(String words) {
      this.words = words;
    }

    abstract String goal(Building building, int number);
  }

  /**
   * @param devices of each building, about, in the order in which they are tried
   * @param progress told what is being done
   */
  public BuildingBench(List<Integer> devices, Consumer<String> progress) {
    this.devices = List.copyOf(devices);
    this.progress = progress;
  }

  /** Measures, one building after the other. */
  public BenchReport run() {
    try (TemporaryDirectory files = TemporaryDirectory.make()) {
      Path classes = files.path().resolve("classes.jsa");
      for (int size : devices) {
        Building building = new Building(size, 1 + (size - 1) / DEVICES_PER_FLOOR, SEED);
        progress.accept("%d devices in %d rooms.".formatted(building.devices(), building.rooms()));
        rows.add(loading(building));
        Path home = write(files.path().resolve("building-" + size + ".ttl"), building);
        if (size == devices.get(0)) {
          ColdPlan.leaveClasses(home, Wish.FETCH.goal(building, 0), PATIENCE, classes);
        }
        for (Wish wish : Wish.values()) {
          if (!tooSlow.contains(wish)) {
            plan(building, home, wish, classes);
          }
        }
        decide(building);
      }
    }
    return new BenchReport("building", BenchReport.thisMachine(), rows);
  }

  private static BenchReport.Row loading(Building building) {
    double best = Double.POSITIVE_INFINITY;
    for (int load = 0; load < WARM_LOADS; load++) {
      long begin = System.nanoTime();
      Home home = new HomeLoader().load(building.homeText(), "building.ttl");
      best = Math.min(best, (System.nanoTime() - begin) / 1e9);
      if (home.devices().size() != building.devices()) {
        throw new IllegalStateException("The building has lost devices on the way.");
      }
    }
    return BenchReport.Row.of(
        "%d devices: home loaded, warm".formatted(building.devices()), best, "s");
  }

  private void plan(Building building, Path home, Wish wish, Path classes) {
    ColdPlan plan = ColdPlan.of(home, wish.goal(building, 0), PATIENCE, classes);
    String name = "%d devices: %s".formatted(building.devices(), wish.words);
    rows.add(
        BenchReport.Row.of(plan.isPlanned() ? name : name + ", given up", plan.seconds(), "s"));
    rows.add(BenchReport.Row.of(name + ", memory", plan.mebibytes(), "MiB"));
    if (!plan.isPlanned()) {
      tooSlow.add(wish);
    }
  }

  /** Of the wishes that are not too much in a cold start. */
  private void decide(Building building) {
    WarmDecisions decisions = new WarmDecisions(building);
    for (Wish wish : Wish.values()) {
      for (WarmDecisions.Known known : WarmDecisions.Known.values()) {
        if (!tooSlow.contains(wish)) {
          List<String> goals =
              IntStream.range(0, GOALS).mapToObj(number -> wish.goal(building, number)).toList();
          rows.add(
              BenchReport.Row.of(
                  "%d devices: %s, decided, %s"
                      .formatted(building.devices(), wish.words, known.words()),
                  decisions.median(known, goals),
                  "s"));
        }
      }
    }
  }

  private static Path write(Path file, Building building) {
    try {
      return Files.writeString(file, building.homeText());
    } catch (IOException e) {
      throw new UncheckedIOException("The building cannot be written.", e);
    }
  }
}
