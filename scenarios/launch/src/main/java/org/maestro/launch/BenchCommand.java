package org.maestro.launch;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.bench.BenchReport;
import org.maestro.bench.ChaosBench;
import org.maestro.bench.CoordinationBench;
import org.maestro.bench.LargeHome;
import org.maestro.bench.RunningBench;
import org.maestro.bench.ScriptsBench;
import org.maestro.bench.SimulationBench;
import org.maestro.bench.SoakBench;
import org.maestro.bench.bus.BusBench;
import org.maestro.bench.console.ConsoleBench;
import org.maestro.bench.containers.AgentsBench;
import org.maestro.bench.containers.ContainersBench;
import org.maestro.bench.containers.GrowthBench;
import org.maestro.bench.containers.OpeningsBench;
import org.maestro.bench.losses.Loss;
import org.maestro.bench.losses.LossesBench;
import org.maestro.bench.planning.BuildingBench;
import org.maestro.bench.planning.CancelBench;
import org.maestro.bench.planning.PlannerBench;
import org.maestro.bench.tracking.TrackingBench;
import org.maestro.dialogue.Paraphraser;
import org.maestro.ontology.home.Home;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Runs a benchmark and prints its figures. */
@Command(
    name = "bench",
    description =
        "Run a benchmark: agents, building, bus, cancel, chaos, console, containers, coordination, growth, language, losses, noise, "
            + "openings, opinion, planner, running, scripts, sim, soak or tracking.")
final class BenchCommand implements Callable<Integer> {
  private static final int AGENTS = 10_000;
  private static final int MANY = 1_000;
  private static final int LEAST_GOALS = 250;

  /** The options that were given. */
  private record Wanted(
      Path directory,
      int runs,
      List<Loss> losses,
      List<Integer> sizes,
      List<Integer> devices,
      int goals,
      Duration duration,
      Function<Consumer<String>, ChaosBench> chaos,
      Optional<Path> utterances,
      Optional<Paraphraser> other,
      long seed) {}

  private static final Map<String, BiFunction<Wanted, Consumer<String>, BenchReport>> BENCHES =
      benches();

  /** A model may be slow the first time that it reads what can be said. */
  private static final Duration OPINION = Duration.ofMinutes(2);

  private static final Duration MEASURED_TIME = Duration.ofSeconds(10);

  /** Devices of the site that is opened again and again. */
  private static final int OPENED = 120;

  @Spec private CommandSpec spec;

  @Parameters(paramLabel = "NAME", description = "Which benchmark.")
  private String name;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "Where growth writes its figures and its picture; here unless it is said.")
  private Path out = Path.of("");

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Option(
      names = "--runs",
      paramLabel = "N",
      description =
          "How often losses and cancel have each happen, openings opens, and noise and language say each"
              + " utterance; how many evenings tracking has; once unless it is said.")
  private int runs = 1;

  @Option(
      names = "--only",
      paramLabel = "LOSS",
      split = ",",
      description =
          "Which losses: none, killed, frozen, cut, slow, all-but-one, main, frozen-main; all"
              + " unless it is said.")
  private List<String> only = List.of();

  @Option(
      names = "--containers",
      paramLabel = "N",
      split = ",",
      description =
          "With how many containers growth is measured, each; 20,50,100,200 unless it is said.")
  private List<Integer> containers = GrowthBench.CONTAINERS;

  @Option(
      names = "--devices",
      paramLabel = "N",
      split = ",",
      description =
          "About how many devices each building has; 40,100,200,400,1000,4000 unless it is said, and"
              + " 40,200,400,1000 of running ones.")
  private List<Integer> devices = BuildingBench.DEVICES;

  @Option(
      names = "--goals",
      paramLabel = "N",
      description = "How many goals soak pursues, from 250; ${DEFAULT-VALUE} unless it is said.")
  private int goals = 1_000;

  @Option(
      names = "--minutes",
      paramLabel = "N",
      description =
          "How long chaos goes on, and the page of console stays open; ${DEFAULT-VALUE} unless it is said.")
  private int minutes = 5;

  @Option(
      names = "--first",
      paramLabel = "N",
      description = "The first seed of chaos; ${DEFAULT-VALUE} unless it is said.")
  private long first = 1;

  @Option(
      names = "--file",
      paramLabel = "FILE.tsv",
      description =
          "The utterances of noise and opinion, as for ./maestro understand, and if wished, after a"
              + " tabulator, what each means.")
  private Optional<Path> utterances = Optional.empty();

  @Option(
      names = "--seed",
      paramLabel = "N",
      description =
          "The one seed of chaos, with its story; that of noise and tracking, 1 unless it is said.")
  private Optional<Long> seed = Optional.empty();

  @Mixin private OpinionOptions opinion;

  private Duration duration() {
    if (minutes < 1) {
      throw CommandException.badInput(
          "--minutes %d is less than one; give 1 or more.".formatted(minutes));
    }
    return Duration.ofMinutes(minutes);
  }

  private ChaosBench chaos(Consumer<String> progress) {
    OptionalLong only = seed.map(OptionalLong::of).orElseGet(OptionalLong::empty);
    return new ChaosBench(only, first, duration(), progress);
  }

  private List<Integer> sizes() {
    if (containers.stream().anyMatch(count -> count < 2)) {
      throw CommandException.badInput(
          "--containers takes numbers from 2; one process of at least two is killed meanwhile.");
    }
    return containers;
  }

  private List<Integer> devices() {
    if (devices.stream().anyMatch(count -> count < 1)) {
      throw CommandException.badInput("--devices takes numbers from 1.");
    }
    return devices;
  }

  private List<Loss> losses() {
    if (runs < 1) {
      throw CommandException.badInput(
          "--runs %d is less than once; give 1 or more.".formatted(runs));
    }
    return only.isEmpty()
        ? List.of(Loss.values())
        : only.stream()
            .map(
                word ->
                    Loss.of(word)
                        .orElseThrow(
                            () ->
                                CommandException.badInput(
                                    "There is no loss %s; there is: %s."
                                        .formatted(
                                            word,
                                            Stream.of(Loss.values())
                                                .map(Loss::word)
                                                .collect(Collectors.joining(", "))))))
            .toList();
  }

  private static Map<String, BiFunction<Wanted, Consumer<String>, BenchReport>> benches() {
    Map<String, BiFunction<Wanted, Consumer<String>, BenchReport>> benches = new TreeMap<>();
    benches.put("agents", (wanted, progress) -> new AgentsBench(AGENTS, progress).run());
    benches.put("chaos", (wanted, progress) -> wanted.chaos().apply(progress).run());
    benches.put(
        "building", (wanted, progress) -> new BuildingBench(wanted.devices(), progress).run());
    benches.put("bus", (wanted, progress) -> new BusBench(progress).run());
    benches.put("cancel", (wanted, progress) -> new CancelBench(wanted.runs(), progress).run());
    benches.put("console", BenchCommand::console);
    benches.put(
        "containers", (wanted, progress) -> new ContainersBench(20, 200, 1_000, 1, progress).run());
    benches.put(
        "coordination",
        (wanted, progress) -> new CoordinationBench(new LargeHome(20, 20, 5), 100, progress).run());
    benches.put(
        "growth",
        (wanted, progress) ->
            new GrowthBench(wanted.directory().toAbsolutePath(), wanted.sizes(), progress).run());
    benches.put("language", (wanted, progress) -> WordsBenches.language(wanted.runs(), progress));
    benches.put(
        "losses",
        (wanted, progress) -> new LossesBench(wanted.losses(), wanted.runs(), progress).run());
    benches.put("noise", BenchCommand::noise);
    benches.put(
        "openings", (wanted, progress) -> new OpeningsBench(OPENED, wanted.runs(), progress).run());
    benches.put("opinion", BenchCommand::opinion);
    benches.put("planner", (wanted, progress) -> new PlannerBench(20, progress).run());
    benches.put(
        "running",
        (wanted, progress) ->
            new RunningBench(
                    wanted.devices().equals(BuildingBench.DEVICES)
                        ? RunningBench.DEVICES
                        : wanted.devices(),
                    progress)
                .run());
    benches.put("scripts", (wanted, progress) -> new ScriptsBench(1_000, 100, progress).run());
    benches.put("sim", (wanted, progress) -> simulation(progress));
    benches.put("soak", (wanted, progress) -> soak(wanted.goals(), progress));
    benches.put("tracking", BenchCommand::tracking);
    return Collections.unmodifiableMap(benches);
  }

  private static BenchReport simulation(Consumer<String> progress) {
    Home arena = Shipped.home("arena");
    return new SimulationBench(
            arena,
            Shipped.scene("arena-dark", arena),
            "(nextTo GreenObject RedObject1)",
            MEASURED_TIME,
            progress)
        .run();
  }

  private static BenchReport tracking(Wanted wanted, Consumer<String> progress) {
    Home people = Shipped.home("people");
    return new TrackingBench(
            people, Shipped.scene("people", people), wanted.runs(), wanted.seed(), progress)
        .run();
  }

  private static BenchReport console(Wanted wanted, Consumer<String> progress) {
    Home bob = Shipped.home("bob");
    int devices = wanted.devices().equals(BuildingBench.DEVICES) ? MANY : wanted.devices().get(0);
    return new ConsoleBench(
            bob, Shipped.scene("bob-dark", bob), devices, wanted.duration(), progress)
        .run();
  }

  private static BenchReport noise(Wanted wanted, Consumer<String> progress) {
    return WordsBenches.noise(utterances("noise", wanted), wanted.runs(), wanted.seed(), progress);
  }

  private static BenchReport opinion(Wanted wanted, Consumer<String> progress) {
    Paraphraser other =
        wanted
            .other()
            .orElseThrow(
                () ->
                    CommandException.badInput(
                        "The benchmark opinion needs somebody to ask; give --second-opinion URL."));
    return WordsBenches.opinion(utterances("opinion", wanted), other, progress);
  }

  private static Path utterances(String bench, Wanted wanted) {
    return wanted
        .utterances()
        .orElseThrow(
            () ->
                CommandException.badInput(
                    "The benchmark %s needs utterances; give --file FILE.tsv.".formatted(bench)));
  }

  private int goals() {
    if (goals < LEAST_GOALS) {
      throw CommandException.badInput(
          "--goals %d is too few for a slope; give %d or more.".formatted(goals, LEAST_GOALS));
    }
    return goals;
  }

  private static BenchReport soak(int goals, Consumer<String> progress) {
    Home bob = Shipped.home("bob");
    return new SoakBench(bob, Shipped.scene("bob-dark", bob), goals, progress).run();
  }

  @Override
  public Integer call() {
    opinion.check();
    BiFunction<Wanted, Consumer<String>, BenchReport> bench = BENCHES.get(name);
    if (bench == null) {
      throw CommandException.badInput(
          "There is no benchmark %s; there is: %s."
              .formatted(name, String.join(", ", BENCHES.keySet())));
    }
    PrintWriter printed = spec.commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    BenchReport report =
        bench.apply(
            new Wanted(
                out,
                runs,
                losses(),
                sizes(),
                devices(),
                goals(),
                duration(),
                this::chaos,
                utterances,
                opinion.paraphraser(OPINION),
                seed.orElse(1L)),
            line -> {
              err.println(line);
              err.flush();
            });
    List<String> lines = json ? List.of(report.json()) : report.lines();
    if (!json) {
      printed.printf("%s, on %s%n", report.bench(), report.machine());
    }
    lines.forEach(printed::println);
    return ExitCode.DONE;
  }
}
