package org.maestro.agents;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.maestro.coordination.Crew;

/**
 * Orders to the generic agents by FIPA request, once it is known that they hold their part. Every
 * order is reported exactly once, whatever its agent does.
 */
final class AclCrew implements Crew {
  private final MaestroAgent agent;
  private final Function<String, Optional<AID>> agentOf;
  private final Contracts contracts;
  private final Misconduct misconduct;
  private final Function<String, Optional<String>> clientOf;
  private final Map<OrderUnderway, String> underway = new LinkedHashMap<>();

  /**
   * @param clientOf for whom others are ordered, by the goal's id, where they want to know it
   */
  AclCrew(
      MaestroAgent agent,
      Function<String, Optional<AID>> agentOf,
      Contracts contracts,
      Misconduct misconduct,
      Function<String, Optional<String>> clientOf) {
    this.agent = agent;
    this.agentOf = agentOf;
    this.contracts = contracts;
    this.misconduct = misconduct;
    this.clientOf = clientOf;
  }

  @Override
  public Performance perform(Order order, Consumer<Report> reported) {
    String member = order.step().member();
    Optional<AID> receiver = agentOf.apply(member);
    if (receiver.isEmpty()) {
      agent.tell(() -> reported.accept(OrderUnderway.failed(member + " has no agent", List.of())));
      return () -> {};
    }
    OrderUnderway performance =
        new OrderUnderway(agent, receiver.get(), order, clientOf.apply(order.goalId()), misconduct);
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
                        ACLMessage.CANCEL, receiver, Orders.callOff(call, agent.getLocalName()))));
  }

  int underwayCount() {
    return underway.size();
  }

  /** The member's agent is no more: whatever it was ordered is not reported by it. */
  void agentEnded(String member) {
    List.copyOf(underway.entrySet()).stream()
        .filter(entry -> entry.getValue().equals(member))
        .forEach(entry -> entry.getKey().agentEnded());
  }
}
