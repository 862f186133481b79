package org.maestro.platform;

import jade.wrapper.AgentContainer;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.function.Supplier;
import org.maestro.agents.device.Surroundings;
import org.maestro.agents.lives.AgentLives;
import org.maestro.agents.pulse.Pulse;
import org.maestro.agents.pulse.Signs;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.supervision.SupervisorOrders;
import org.maestro.coordination.api.Recovery;
import org.maestro.deployment.ContainerStart;
import org.maestro.deployment.Provision;
import org.maestro.ontology.home.Group;
import org.maestro.platform.failover.AgentFailover;
import org.maestro.platform.failover.FormerCallers;
import org.maestro.platform.failover.HostSupervisor;
import org.maestro.platform.failover.SignsOfLife;
import org.maestro.platform.failover.TakeoverLinks;
import org.maestro.platform.jade.MainContainer;
import org.maestro.rats.link.RatsLink;

/**
 * The agents that stand for members and groups: they get their places when a member comes, are
 * watched, and begin elsewhere when they are lost or hang (Three-layered architecture, 3.3.2;
 * M69-M72). Any thread may use it.
 */
final class MemberAgents {
  private static final String GROUPS = "groups";

  /** Containers that have outlived a platform have joined the next one by then. */
  private static final Duration RETURN = Duration.ofSeconds(15);

  private final PlatformSettings settings;
  private final PlatformServices services;
  private final AgentLives lives;
  private final Supplier<Collection<String>> present;
  private final Supplier<SupervisorOrders> orders;
  private final TakeoverLinks heirs;
  private final Deployer deployer;
  private final AgentFailover rescue;
  private final HostSupervisor starter;
  private final Arrivals arrivals;
  private final SignsOfLife signs;

  /**
   * @param here what this process's containers give to their agents
   * @param before what was under way when the platform ended the last time
   * @param present members that can be used at the time
   * @param orders of the supervisor, which is made after those whom it supervises
   */
  MemberAgents(
      PlatformSettings settings,
      PlatformServices services,
      MainContainer main,
      Surroundings here,
      AgentLives lives,
      Recovery before,
      Supplier<Collection<String>> present,
      Supplier<SupervisorOrders> orders) {
    this.settings = settings;
    this.services = services;
    this.lives = lives;
    this.present = present;
    this.orders = orders;
    this.heirs = new TakeoverLinks(services.otherNames());
    this.deployer =
        new Deployer(here, main::join, heirs, main.agentsByName(), settings.premises().provides());
    this.rescue =
        new AgentFailover(
            new FailoverWays(services.knowledge()::home, deployer, orders, present, lives),
            services.clock(),
            Provision.of(settings.premises().provides()),
            services.link().controller(),
            services.otherNames()::mayBeUsed);
    this.starter =
        new HostSupervisor(
            settings.premises().hosts(),
            main.address(),
            settings.dataDirectory().orElseGet(main::files),
            deployer::isElsewhere);
    this.arrivals =
        new Arrivals(
            services.knowledge(),
            services.describedBy(),
            services.clock(),
            deployer,
            rescue,
            FormerCallers.of(before, services.link().controller()),
            services.link());
    this.signs =
        new SignsOfLife(
            services.clock(),
            settings.heartbeats(),
            main.shared().wires(),
            deployer::containers,
            lives);
  }

  /** What becomes of agents that are lost or hang is seen to from now on. */
  void listen() {
    lives.listen(new Departures(deployer, rescue, starter, signs, lives));
  }

  /** The devices of the home get their agents. */
  void begin() {
    arrivals.ofHome();
  }

  void begin(Group group, MaestroAgent agent) {
    deployer.placeGroup(group.id(), container(group), agent);
  }

  /** Where the agent of a group lives. */
  static String container(Group group) {
    return group.container().orElse(GROUPS);
  }

  /** The agent of a group ends for good. */
  void end(String group) {
    deployer.removeGroup(group);
  }

  /**
   * The other hosts that this platform starts begin.
   *
   * @param again whether the platform goes on with what was under way, and they may have outlived
   *     it
   */
  void beginHosts(boolean again) {
    if (settings.guard().isPresent()) {
      new RevokedNames(deployer, services.otherNames()::mayBeUsed, services.clock(), lives).watch();
    }
    starter.begin(again ? RETURN : Duration.ZERO);
  }

  void memberChanged(RatsLink.Member member) {
    arrivals.memberChanged(member);
  }

  /** Members that are there and cannot be used as they describe themselves, and why. */
  SortedMap<String, Arrivals.Refusal> refused() {
    return arrivals.refused(present.get());
  }

  /** Waits a while: whether the agents of the home have their places. */
  boolean awaitHome() {
    return arrivals.awaitHome();
  }

  /** A container of another process is to get agents; nobody else calls under its name then. */
  void admit(ContainerStart container, String asker) {
    deployer.admit(
        container,
        asker,
        agent -> {
          rescue.settled(agent);
          lives.tell(listener -> listener.agentMoves(agent));
        });
    String controller = TakeoverLinks.controller(container.name());
    rescue.released(controller).ifPresent(holder -> orders.get().letGo(holder, controller));
  }

  /** A host is there for agents that need what it provides. */
  void offered(String host, List<String> provides) {
    rescue.offered(host, provides);
  }

  /** The containers' signs of life can be heard from now on. */
  void watchOver(Pulse pulse) {
    signs.watch(pulse);
  }

  /** What is known by signs of life; of none on a stepped clock. */
  Signs signs() {
    return signs.signs();
  }

  /** Members whose agents need what no host that is there provides. */
  Set<String> homeless() {
    return rescue.homeless();
  }

  Deployer deployer() {
    return deployer;
  }

  /** No other host is started any more. */
  void closeHosts() {
    starter.close();
  }

  /**
   * No agent is started any more; returns the containers of this process, which are to be ended.
   */
  List<AgentContainer> close() {
    heirs.close();
    return deployer.close();
  }
}
