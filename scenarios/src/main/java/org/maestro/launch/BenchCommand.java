package org.maestro.launch;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import org.maestro.bench.AgentsBench;
import org.maestro.bench.BenchReport;
import org.maestro.bench.BusBench;
import org.maestro.bench.ContainersBench;
import org.maestro.bench.CoordinationBench;
import org.maestro.bench.GrowthBench;
import org.maestro.bench.LargeHome;
import org.maestro.bench.PlannerBench;
import org.maestro.bench.SimulationBench;
import org.maestro.ontology.home.Home;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Runs a benchmark and prints its figures. */
@Command(
    name = "bench",
    description = "Run a benchmark: agents, bus, containers, coordination, growth, planner or sim.")
final class BenchCommand implements Callable<Integer> {
  private static final int AGENTS = 10_000;

  private static final Map<String, BiFunction<Path, Consumer<String>, BenchReport>> BENCHES =
      new TreeMap<>(
          Map.of(
              "agents",
              (out, progress) -> new AgentsBench(AGENTS, progress).run(),
              "bus",
              (out, progress) -> new BusBench(progress).run(),
              "containers",
              (out, progress) -> new ContainersBench(20, 200, 1_000, 1, progress).run(),
              "coordination",
              (out, progress) ->
                  new CoordinationBench(new LargeHome(20, 20, 5), 100, progress).run(),
              "growth",
              (out, progress) -> new GrowthBench(out.toAbsolutePath(), progress).run(),
              "planner",
              (out, progress) -> new PlannerBench(20, progress).run(),
              "sim",
              (out, progress) -> simulation(progress)));

  private static final Duration MEASURED_TIME = Duration.ofSeconds(10);

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

  @Override
  public Integer call() {
    BiFunction<Path, Consumer<String>, BenchReport> bench = BENCHES.get(name);
    if (bench == null) {
      throw CommandException.badInput(
          "There is no benchmark %s; there is: %s."
              .formatted(name, String.join(", ", BENCHES.keySet())));
    }
    PrintWriter printed = spec.commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    BenchReport report =
        bench.apply(
            out,
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
