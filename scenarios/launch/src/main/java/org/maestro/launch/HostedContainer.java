package org.maestro.launch;

import java.net.URI;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import org.maestro.agents.supervision.Handover;
import org.maestro.assembly.SiteBus;
import org.maestro.deployment.ContainerStart;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.ReplanningPlanner;
import org.maestro.platform.JoinedContainer;
import org.maestro.platform.ThinkingPart;
import org.maestro.platform.guard.Guard;
import org.maestro.platform.jade.NameTakenException;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.security.SiteSecurity;
import org.maestro.rats.time.Clock;

/** A container for agents in this process, from joining the platform to leaving it. */
final class HostedContainer implements AutoCloseable {
  private final JoinedContainer container;
  private final Links links;
  private final List<String> agents;

  private HostedContainer(JoinedContainer container, Links links, List<String> agents) {
    this.container = container;
    this.links = links;
    this.agents = agents;
  }

  /** Parts of the central agent that are to live in it, and the home that they think of. */
  record Thinking(Home home, Set<ThinkingPart> parts) {}

  /**
   * Joins.
   *
   * @param attempt from 1, each another: an agent that asks on its behalf must not have the name of
   *     one that is still ending
   * @throws PlatformStartException when the platform is not there, or does not let it in
   */
  static HostedContainer begin(
      Endpoint at,
      ContainerStart start,
      Optional<Thinking> thinking,
      int attempt,
      Clock clock,
      Optional<SiteSecurity> security) {
    String controller = controller(start.name());
    JoinedContainer container = join(at, start.name(), attempt, clock, security);
    Links links = new Links(clock, security);
    try {
      Handover handover = container.ask(start);
      DescriptionReader reader =
          new DescriptionReader(
              new HomeLoader().vocabularyWith(handover.words()), handover.words());
      List<String> agents = container.host(start, links.at(handover).of(controller), reader::read);
      if (!start.provides().isEmpty()) {
        container.offer(start.name(), List.copyOf(start.provides()), links::at, reader::read);
      }
      thinking.ifPresent(
          its ->
              container.think(
                  start.name(),
                  its.home(),
                  its.parts(),
                  new ReplanningPlanner(new OptimalPlanner())));
      return new HostedContainer(container, links, agents);
    } catch (RuntimeException e) {
      links.close();
      container.abandon();
      throw e;
    }
  }

  /** Who hands over has a container beside that for agents, which lives as long as it. */
  private static JoinedContainer join(
      Endpoint at, String name, int attempt, Clock clock, Optional<SiteSecurity> security) {
    try {
      return JoinedContainer.join(
          Optional.empty(),
          at.host(),
          at.port(),
          name + "-hand-over" + (attempt == 1 ? "" : "-" + attempt),
          clock,
          security.map(site -> Guard.open(site, controller(name))));
    } catch (NameTakenException e) {
      throw new NameTakenException(name);
    }
  }

  private static String controller(String name) {
    return "container-" + name;
  }

  /** The links of this process to the bus, by controller. */
  private static final class Links implements JoinedContainer.Links, AutoCloseable {
    private final Clock clock;
    private final Optional<SiteSecurity> security;
    private final Map<String, RatsLink> linkByController = new ConcurrentHashMap<>();
    private volatile Optional<Function<String, RatsLink>> making = Optional.empty();

    private Links(Clock clock, Optional<SiteSecurity> security) {
      this.clock = clock;
      this.security = security;
    }

    private Links at(Handover handover) {
      URI broker = Endpoint.broker(handover.brokerUri());
      SiteBus bus = new SiteBus(broker, handover.site(), security);
      making =
          Optional.of(
              name ->
                  BusLink.connectForWatched(
                      name, handover.site(), bus.transports().apply(name), clock, bus.kind()));
      return this;
    }

    @Override
    public RatsLink of(String controller) {
      return linkByController.computeIfAbsent(controller, making.orElseThrow());
    }

    @Override
    public void letGo(String controller) {
      Optional.ofNullable(linkByController.remove(controller)).ifPresent(RatsLink::close);
    }

    @Override
    public void close() {
      linkByController.values().forEach(RatsLink::close);
    }
  }

  List<String> agents() {
    return agents;
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
