package org.maestro.launch;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import org.maestro.assembly.OpenFiles;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.PacedClock;
import org.maestro.sim.SimulatedHome;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Simulated devices in a process of their own. */
@Command(
    name = "devices",
    description = "Run simulated devices in a process of their own, until Ctrl-C.")
final class DevicesCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Mixin private SimulationOptions simulation;

  @Mixin private SiteOptions options;

  @Option(names = "--only", split = ",", paramLabel = "ID", description = "Only these devices.")
  private List<String> only = List.of();

  @Override
  public Integer call() throws InterruptedException {
    PacedClock clock = new PacedClock(simulation.speed());
    Home loaded = simulation.home();
    Set<String> wanted = new LinkedHashSet<>(only);
    wanted.forEach(id -> HomeDevice.named(id, loaded));
    OpenFiles.requireFor(wanted.isEmpty() ? loaded.devices().size() : wanted.size());
    SiteOptions.Found site =
        options.join((wanted.isEmpty() ? loaded.devices().keySet() : wanted).iterator().next());
    SimulatedHome.Setup setup =
        new SimulatedHome.Setup(
                loaded,
                simulation.scene(loaded, "A home of your own needs --scene FILE."),
                clock,
                simulation.seed(),
                site.bus().transports(),
                site.name(),
                new DescriptionWriter(loaded)::write)
            .withPolicy(site.bus().policy());
    SimulatedHome simulated = SimulatedHome.start(wanted.isEmpty() ? setup : setup.only(wanted));
    UntilStopped.run(
        spec.commandLine().getOut(),
        "Simulated devices on %s: %s."
            .formatted(site.broker(), String.join(", ", simulated.devices())),
        simulated::close);
    return ExitCode.DONE;
  }
}
