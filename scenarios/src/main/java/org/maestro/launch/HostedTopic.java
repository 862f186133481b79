package org.maestro.launch;

import java.net.URI;
import java.util.List;
import java.util.Optional;
import org.maestro.agents.SupervisorAgent;
import org.maestro.assembly.SiteBus;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.JoinedContainer;
import org.maestro.platform.PlatformStartException;
import org.maestro.platform.guard.Guard;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.security.SiteSecurity;
import org.maestro.rats.time.Clock;

/** A topic's agents in this process, from joining the platform to leaving it. */
final class HostedTopic implements AutoCloseable {
  private final JoinedContainer container;
  private final BusLink link;
  private final List<String> members;

  private HostedTopic(JoinedContainer container, BusLink link, List<String> members) {
    this.container = container;
    this.link = link;
    this.members = members;
  }

  /**
   * Joins, and takes the topic over.
   *
   * @throws PlatformStartException when the platform is not there, or keeps the topic
   */
  static HostedTopic begin(Endpoint at, String name, Clock clock, Optional<SiteSecurity> security) {
    String controller = "container-" + name;
    JoinedContainer container =
        JoinedContainer.join(
            Optional.empty(),
            at.host(),
            at.port(),
            name + "-hand-over",
            clock,
            security.map(site -> Guard.open(site, controller)));
    try {
      SupervisorAgent.Handover handover = container.take(name);
      URI broker = Endpoint.broker(handover.brokerUri());
      SiteBus bus = new SiteBus(broker, handover.site(), security);
      BusLink link =
          BusLink.connect(
              controller, handover.site(), bus.transports().apply(controller), clock, bus.kind());
      container.host(
          name,
          handover.members(),
          link,
          new DescriptionReader(new HomeLoader().vocabulary())::read);
      return new HostedTopic(container, link, handover.members());
    } catch (RuntimeException e) {
      container.abandon();
      throw e;
    }
  }

  List<String> members() {
    return members;
  }

  /** See {@link JoinedContainer#whenGivenUp}. */
  void whenGivenUp(Runnable listener) {
    container.whenGivenUp(listener);
  }

  /** The platform does not know it any more: its connection to the bus ends first. */
  void abandon() {
    link.close();
    container.abandon();
  }

  @Override
  public void close() {
    container.close();
    link.close();
  }
}
