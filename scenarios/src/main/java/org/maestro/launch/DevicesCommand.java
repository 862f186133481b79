package org.maestro.launch;

import java.io.PrintWriter;
import java.net.URI;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.sim.SimulatedHome;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Simulated devices in a process of their own. */
@Command(
    name = "devices",
    description = "Run simulated devices in a process of their own, until Ctrl-C.")
final class DevicesCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Parameters(paramLabel = "HOME.ttl", description = "A home file, or a shipped home: bob, arena.")
  private String home;

  @Option(names = "--only", split = ",", paramLabel = "ID", description = "Only these devices.")
  private List<String> only = List.of();

  @Option(
      names = "--scene",
      paramLabel = "S.ttl",
      description = "Ground truth of the simulated world.")
  private Optional<String> scene;

  @Option(
      names = "--broker",
      paramLabel = "URI",
      required = true,
      description = "The MQTT 5 broker, tcp://HOST:PORT.")
  private String broker;

  @Option(
      names = "--site",
      paramLabel = "NAME",
      defaultValue = "maestro",
      description = "The platform's name; default ${DEFAULT-VALUE}.")
  private String site;

  @Option(
      names = "--speed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Simulated seconds per second; default ${DEFAULT-VALUE}.")
  private double speed;

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Of all chance in the world; default ${DEFAULT-VALUE}.")
  private long seed;

  @Override
  public Integer call() throws InterruptedException {
    Speed.require(speed);
    Home loaded = Shipped.home(home);
    Set<String> wanted = new LinkedHashSet<>(only);
    for (String id : wanted) {
      if (!loaded.devices().containsKey(id)) {
        throw CommandException.badInput(
            "The home has no device %s; it has %s."
                .formatted(id, String.join(", ", loaded.devices().keySet())));
      }
    }
    String sceneName =
        scene
            .or(() -> Shipped.usualScene(home))
            .orElseThrow(() -> CommandException.badInput("A home of your own needs --scene FILE."));
    URI uri = Endpoint.broker(broker);
    SimulatedHome.Setup setup =
        new SimulatedHome.Setup(
            loaded,
            Shipped.scene(sceneName, loaded),
            new PacedClock(speed),
            seed,
            id -> new PahoTransport(uri, site + "-" + id),
            site,
            new DescriptionWriter(loaded)::write);
    SimulatedHome simulated = SimulatedHome.start(wanted.isEmpty() ? setup : setup.only(wanted));
    Runtime.getRuntime().addShutdownHook(new Thread(simulated::close, "shutdown"));
    PrintWriter out = spec.commandLine().getOut();
    out.printf(
        "Simulated devices on %s: %s. Stop with Ctrl-C.%n",
        uri, String.join(", ", simulated.devices()));
    out.flush();
    new CountDownLatch(1).await();
    return ExitCode.DONE;
  }
}
