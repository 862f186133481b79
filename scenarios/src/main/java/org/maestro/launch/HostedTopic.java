package org.maestro.launch;

import java.net.URI;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import org.maestro.agents.SupervisorAgent;
import org.maestro.assembly.SiteBus;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.JoinedContainer;
import org.maestro.platform.PlatformStartException;
import org.maestro.platform.guard.Guard;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.security.SiteSecurity;
import org.maestro.rats.time.Clock;

/** A topic's agents in this process, from joining the platform to leaving it. */
final class HostedTopic implements AutoCloseable {
  private final JoinedContainer container;
  private final Links links;
  private final List<String> members;

  /**
   * @param topic whose agents it takes; empty: none
   * @param provides what it offers to agents that need it; empty: it takes no others
   */
  record Wish(String name, Optional<String> topic, List<String> provides) {}

  private HostedTopic(JoinedContainer container, Links links, List<String> members) {
    this.container = container;
    this.links = links;
    this.members = members;
  }

  /**
   * Joins, takes the topic over if one is wished for, and offers itself as a host.
   *
   * @throws PlatformStartException when the platform is not there, or refuses
   */
  static HostedTopic begin(Endpoint at, Wish wish, Clock clock, Optional<SiteSecurity> security) {
    String controller = "container-" + wish.topic().orElse(wish.name());
    JoinedContainer container =
        JoinedContainer.join(
            Optional.empty(),
            at.host(),
            at.port(),
            wish.name() + "-hand-over",
            clock,
            security.map(site -> Guard.open(site, controller)));
    Links links = new Links(clock, security);
    try {
      DescriptionReader reader = new DescriptionReader(new HomeLoader().vocabulary());
      List<String> members = List.of();
      if (wish.topic().isPresent()) {
        SupervisorAgent.Handover handover = container.take(wish.topic().get());
        members = handover.members();
        container.host(
            wish.topic().get(), members, links.of(handover).apply(controller), reader::read);
      }
      if (!wish.provides().isEmpty()) {
        container.offer(wish.topic().orElse(wish.name()), wish.provides(), links::of, reader::read);
      }
      return new HostedTopic(container, links, members);
    } catch (RuntimeException e) {
      links.close();
      container.abandon();
      throw e;
    }
  }

  /** The links of this process to the bus, by controller. */
  private static final class Links implements AutoCloseable {
    private final Clock clock;
    private final Optional<SiteSecurity> security;
    private final Map<String, RatsLink> linkByController = new ConcurrentHashMap<>();

    private Links(Clock clock, Optional<SiteSecurity> security) {
      this.clock = clock;
      this.security = security;
    }

    private Function<String, RatsLink> of(SupervisorAgent.Handover handover) {
      URI broker = Endpoint.broker(handover.brokerUri());
      SiteBus bus = new SiteBus(broker, handover.site(), security);
      return controller ->
          linkByController.computeIfAbsent(
              controller,
              name ->
                  BusLink.connect(
                      name, handover.site(), bus.transports().apply(name), clock, bus.kind()));
    }

    @Override
    public void close() {
      linkByController.values().forEach(RatsLink::close);
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
    links.close();
    container.abandon();
  }

  @Override
  public void close() {
    container.close();
    links.close();
  }
}
