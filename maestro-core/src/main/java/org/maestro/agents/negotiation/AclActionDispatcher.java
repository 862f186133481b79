package org.maestro.agents.negotiation;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import org.maestro.agents.content.ArbitrationWords;
import org.maestro.agents.content.Orders;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.sl.Content;

/**
 * Orders to the generic agents by FIPA request, once it is known that they hold their part. Every
 * order is reported exactly once, whatever its agent does.
 */
public final class AclActionDispatcher implements ActionDispatcher {
  /** A member that is asked what it says of itself has so long, its agent included. */
  private static final Duration HEARD_WITHIN = Duration.ofSeconds(5);

  private final MaestroAgent agent;
  private final Function<String, Optional<AID>> agentOf;
  private final Predicate<String> isDoubted;
  private final Contracts contracts;
  private final ProtocolViolations misconduct;
  private final Function<String, Optional<String>> clientOf;
  private final Map<OrderUnderway, String> underway = new LinkedHashMap<>();

  /**
   * @param isDoubted whether a member without an agent may have one again soon, so that its orders
   *     are held back until it is told that it has, or has not
   * @param clientOf for whom others are ordered, by the goal's id, where they want to know it
   */
  public AclActionDispatcher(
      MaestroAgent agent,
      Function<String, Optional<AID>> agentOf,
      Predicate<String> isDoubted,
      Contracts contracts,
      ProtocolViolations misconduct,
      Function<String, Optional<String>> clientOf) {
    this.agent = agent;
    this.agentOf = agentOf;
    this.isDoubted = isDoubted;
    this.contracts = contracts;
    this.misconduct = misconduct;
    this.clientOf = clientOf;
  }

  @Override
  public Handle perform(Request order, Consumer<Report> reported) {
    String member = order.step().member();
    if (agentOf.apply(member).isEmpty() && !isDoubted.test(member)) {
      agent.tell(() -> reported.accept(OrderUnderway.failed(member + " has no agent", List.of())));
      return () -> {};
    }
    OrderUnderway performance =
        new OrderUnderway(
            agent, () -> agentOf.apply(member), order, clientOf.apply(order.goalId()), misconduct);
    underway.put(performance, member);
    performance.reportTo(
        report -> {
          underway.remove(performance);
          reported.accept(report);
        });
    contracts.whenSettled(order.goalId(), member, performance::contractSettled);
    return performance;
  }

  @Override
  public void callOff(String member, Call call) {
    agentOf
        .apply(member)
        .ifPresent(
            receiver ->
                agent.send(
                    agent.message(
                        ACLMessage.CANCEL,
                        receiver,
                        Orders.callOff(
                            call, agent.getLocalName(), member, receiver.getLocalName()))));
  }

  @Override
  public void want(ComponentWant want) {
    request(want.member(), ArbitrationWords.want(want, agent.clock().now()));
  }

  @Override
  public void wantNoMore(String goalId, String member) {
    request(member, ArbitrationWords.wantNoMore(goalId, member));
  }

  @Override
  public void giveBack(String member, Set<String> components) {
    request(member, ArbitrationWords.giveBack(member, components));
  }

  /** A member that has no agent now is asked anew when it has one. */
  private void request(String member, Content words) {
    agentOf
        .apply(member)
        .ifPresent(receiver -> agent.send(agent.message(ACLMessage.REQUEST, receiver, words)));
  }

  @Override
  public void ask(String member, Runnable heard) {
    Optional<AID> receiver = agentOf.apply(member);
    if (receiver.isEmpty()) {
      agent.tell(heard);
      return;
    }
    agent.ask(
        agent.message(
            ACLMessage.REQUEST,
            receiver.get(),
            Words.content("describe", Words.named("member", Words.name(member)))),
        HEARD_WITHIN,
        reply -> heard.run());
  }

  @Override
  public void alive(String goalId, String member, String feature) {
    ordersOf(member).stream()
        .filter(order -> order.isOf(goalId, feature))
        .forEach(OrderUnderway::alive);
  }

  public int underwayCount() {
    return underway.size();
  }

  /** The member's agent is no more: whatever it was ordered is not reported by it. */
  public void agentEnded(String member) {
    ordersOf(member).forEach(OrderUnderway::agentEnded);
  }

  /** The member's agent is no more, and another is to take its orders over. */
  public void agentMoves(String member) {
    ordersOf(member).forEach(OrderUnderway::agentMoves);
  }

  /** The member has an agent that can be asked: what was held back is ordered now. */
  public void agentThere(String member) {
    ordersOf(member).forEach(OrderUnderway::goOn);
  }

  /** The member is gone: nobody takes up what was held back. */
  public void memberLost(String member) {
    ordersOf(member).stream().filter(OrderUnderway::isHeld).forEach(OrderUnderway::agentEnded);
  }

  private List<OrderUnderway> ordersOf(String member) {
    return underway.entrySet().stream()
        .filter(entry -> entry.getValue().equals(member))
        .map(Map.Entry::getKey)
        .toList();
  }
}
