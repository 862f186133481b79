package org.maestro.launch;

import java.net.URI;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.maestro.agents.SupervisorAgent;
import org.maestro.assembly.SiteBus;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.JoinedContainer;
import org.maestro.platform.guard.Guard;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.security.SiteSecurity;
import org.maestro.rats.time.PacedClock;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Takes one of a platform's topical containers into this process. */
@Command(
    name = "container",
    description = "Take one of a platform's topical containers over, until Ctrl-C.")
final class ContainerCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Option(
      names = "--main",
      paramLabel = "HOST:PORT",
      required = true,
      description = "Where the platform's JADE main container listens.")
  private String main;

  @Mixin private SecurityOptions security;

  @Option(
      names = "--name",
      paramLabel = "NAME",
      required = true,
      description = "The topic: robots, cameras, lights, sensors.")
  private String name;

  @Override
  public Integer call() throws InterruptedException {
    Endpoint at = Endpoint.parse(main);
    PacedClock clock = new PacedClock(1);
    String controller = "container-" + name;
    Optional<SiteSecurity> files = security.files();
    JoinedContainer container =
        JoinedContainer.join(
            Optional.empty(),
            at.host(),
            at.port(),
            name + "-hand-over",
            clock,
            files.map(site -> Guard.open(site, controller)));
    SupervisorAgent.Handover handover = container.take(name);
    URI broker = Endpoint.broker(handover.brokerUri());
    SiteBus bus = new SiteBus(broker, handover.site(), files);
    BusLink link =
        BusLink.connect(
            controller, handover.site(), bus.transports().apply(controller), clock, bus.kind());
    container.host(
        name, handover.members(), link, new DescriptionReader(new HomeLoader().vocabulary())::read);
    UntilStopped.run(
        spec.commandLine().getOut(),
        "The container %s runs here, with %s."
            .formatted(name, String.join(", ", handover.members())),
        () -> {
          container.close();
          link.close();
        });
    return ExitCode.DONE;
  }
}
