package org.maestro.platform;

import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.maestro.agents.pulse.Pulse;
import org.maestro.agents.supervision.SupervisorOrders;
import org.maestro.platform.failover.AgentFailover;
import org.maestro.platform.failover.SignsOfLife;
import org.maestro.platform.failover.TakeoverLinks;

/** The platform around the supervision: those it tells, and who revives whom. */
final class PlatformCentre implements Supervision.Centre {
  private final Arrivals arrivals;
  private final Principals principals;
  private final BooleanSupplier reviving;
  private final AgentFailover rescue;
  private final Supplier<SupervisorOrders> orders;
  private final SignsOfLife signs;

  /**
   * @param reviving begins the central agent again; false when it is there
   * @param orders of the supervisor, which is made after those whom it supervises
   */
  PlatformCentre(
      Arrivals arrivals,
      Principals principals,
      BooleanSupplier reviving,
      AgentFailover rescue,
      Supplier<SupervisorOrders> orders,
      SignsOfLife signs) {
    this.arrivals = arrivals;
    this.principals = principals;
    this.reviving = reviving;
    this.rescue = rescue;
    this.orders = orders;
    this.signs = signs;
  }

  @Override
  public boolean isPlaced() {
    return arrivals.awaitHome();
  }

  @Override
  public void agentMoves(String agent) {
    principals.agentMoves(agent);
  }

  @Override
  public boolean revive() {
    return reviving.getAsBoolean();
  }

  @Override
  public void offered(String offering, List<String> provides) {
    rescue.offered(offering, provides);
  }

  @Override
  public void settled(String agent) {
    rescue.settled(agent);
  }

  @Override
  public void returns(String container) {
    String controller = TakeoverLinks.controller(container);
    rescue.released(controller).ifPresent(holder -> orders.get().letGo(holder, controller));
  }

  @Override
  public void watchOver(Pulse pulse) {
    signs.watch(pulse);
  }
}
