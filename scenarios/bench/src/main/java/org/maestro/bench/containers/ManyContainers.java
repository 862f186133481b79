package org.maestro.bench.containers;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.maestro.agents.supervision.Handover;
import org.maestro.assembly.SiteBus;
import org.maestro.deployment.ContainerStart;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.JoinedContainer;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.time.PacedClock;

/**
 * A process with several containers for agents, as of so many hosts, until who started it ends:
 * {@code PORT NAME FIRST COUNT}.
 */
public final class ManyContainers {
  static final String READY = "ready";

  private ManyContainers() {}

  public static void main(String[] arguments) throws IOException {
    int port = Integer.parseInt(arguments[0]);
    String name = arguments[1];
    int first = Integer.parseInt(arguments[2]);
    int count = Integer.parseInt(arguments[3]);
    PacedClock clock = new PacedClock(1);
    DescriptionReader reader = new DescriptionReader(new HomeLoader().vocabulary());
    JoinedContainer joined = JoinedContainer.join("127.0.0.1", port, name, clock);
    List<String> names = IntStream.range(first, first + count).mapToObj(Dial::container).toList();
    for (String container : names) {
      ContainerStart start = new ContainerStart(container, Set.of(container), Set.of(), false);
      Handover handover = joined.ask(start);
      joined.host(start, link(container, handover, clock), reader::read);
    }
    PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    out.println(READY);
    // Whoever started this process may be killed; it must not be left behind.
    System.in.transferTo(OutputStream.nullOutputStream());
    System.exit(0);
  }

  private static RatsLink link(String container, Handover handover, PacedClock clock) {
    String controller = "container-" + container;
    SiteBus bus = new SiteBus(URI.create(handover.brokerUri()), handover.site(), Optional.empty());
    return BusLink.connectForWatched(
        controller, handover.site(), bus.transports().apply(controller), clock, bus.kind());
  }
}
