package org.maestro.agents.calls;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Proposal;
import org.maestro.members.MemberOrders;
import org.maestro.planning.api.Step;

/**
 * A generic agent's own member, as the agent's own plans use it: no messages are needed. Agent
 * thread only.
 */
public final class OwnMember implements ContractNet, ActionDispatcher {
  private final String member;
  private final MemberOrders orders;
  private final ActionExecution actions;
  private int calls;

  public OwnMember(String member, MemberOrders orders, ActionExecution actions) {
    this.member = member;
    this.orders = orders;
    this.actions = actions;
  }

  @Override
  public void callForPrices(CallForPrices call, Consumer<Round> closed) {
    List<String> wanted = call.features().getOrDefault(member, List.of());
    if (wanted.isEmpty()) {
      closed.accept(new Alone(List.of()));
      return;
    }
    closed.accept(new Alone(List.of(orders.bid(wanted))));
  }

  @Override
  public void exactPrices(
      String goalId,
      String asked,
      String feature,
      List<Map<String, Argument>> sets,
      Consumer<List<Quote>> answer) {
    orders.quote(feature, sets, answer);
  }

  @Override
  public Handle perform(Request order, Consumer<Report> reported) {
    return actions.begin(
            "own-" + ++calls,
            new MemberOrders.Order(
                order.step().feature(),
                order.parameters(),
                order.timeout(),
                order.call().map(Call::id),
                actions.boot(),
                Optional.of(order.goalId()),
                Optional.empty(),
                order.ends()),
            Optional.empty(),
            (outcome, report) -> reported.accept(report))
        ::cancel;
  }

  @Override
  public void callOff(String whose, Call call) {
    actions.callOff(call.id());
  }

  /** A round with one bidder, who needs no award. */
  private record Alone(List<Proposal> bids) implements Round {
    @Override
    public void award(Map<String, List<Step>> parts) {
      // It is the agent's own member: it gets its orders.
    }
  }
}
