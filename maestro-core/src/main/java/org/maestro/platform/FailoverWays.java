package org.maestro.platform;

import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.agents.lives.AgentLives;
import org.maestro.agents.supervision.SupervisorOrders;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.Provision;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.platform.failover.AgentFailover;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The failover of agents without a host on a platform, and who is told when nobody takes them. */
final class FailoverWays implements AgentFailover.Ways {
  private static final Logger LOG = LoggerFactory.getLogger(FailoverWays.class);

  private final Supplier<Home> home;
  private final Deployer deployer;
  private final Supplier<SupervisorOrders> orders;
  private final Supplier<Collection<String>> present;
  private final AgentLives lives;

  /**
   * @param home as it is known at the time
   * @param orders of the supervisor, which is made after those whom it supervises
   * @param present members that can be used at the time
   */
  FailoverWays(
      Supplier<Home> home,
      Deployer deployer,
      Supplier<SupervisorOrders> orders,
      Supplier<Collection<String>> present,
      AgentLives lives) {
    this.home = home;
    this.deployer = deployer;
    this.orders = orders;
    this.present = present;
    this.lives = lives;
  }

  @Override
  public Provision needs(String member) {
    Set<String> needs = new TreeSet<>();
    Optional<AgentStart> start = deployer.deployment().find(member);
    start.ifPresent(known -> needs.addAll(known.needs()));
    start.map(AgentStart::members).orElse(List.of(member)).stream()
        .map(home.get().devices()::get)
        .filter(Objects::nonNull)
        .forEach(device -> needs.addAll(device.hostNeeds()));
    return Provision.of(needs);
  }

  @Override
  public void beginHere(String member, String controller) {
    deployer.reclaim(member, controller);
  }

  @Override
  public void beginThere(
      String hosting, String member, String controller, Consumer<Optional<String>> problem) {
    AgentStart start = deployer.deployment().require(member).in(hosting);
    deployer.rescued(member, hosting, controller);
    orders.get().beginOn(hosting, start, controller, problem);
  }

  @Override
  public void nobody(String member, String why) {
    List<Device> there =
        present.get().stream().map(home.get().devices()::get).filter(Objects::nonNull).toList();
    String reason =
        Optional.ofNullable(home.get().devices().get(member))
            .map(device -> why + "; " + Remaining.inWords(device, there))
            .orElse(why);
    LOG.warn(
        "There is a problem with {}: {}. It is there again as soon as such a host joins.",
        member,
        reason);
    lives.tell(listener -> listener.agentStaysAway(member, reason));
    orders.get().tellLost(member, reason, home.get().groups().keySet());
  }
}
