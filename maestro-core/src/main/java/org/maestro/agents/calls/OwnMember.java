package org.maestro.agents.calls;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.HeldElsewhere;
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
  private final Arbitration arbitration;
  private final Executor later;
  private int calls;

  /**
   * @param later has the agent's thread do something soon
   */
  public OwnMember(
      String member,
      MemberOrders orders,
      ActionExecution actions,
      Arbitration arbitration,
      Executor later) {
    this.member = member;
    this.orders = orders;
    this.actions = actions;
    this.arbitration = arbitration;
    this.later = later;
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
    Optional<HeldElsewhere> other =
        order.ends()
            ? Optional.empty()
            : arbitration.useOwn(order.goalId(), order.step().feature());
    if (other.isPresent()) {
      later.execute(
          () ->
              reported.accept(
                  Report.held(
                      other.get(), other.get().manager() + " has what it needs of " + member)));
      return () -> {};
    }
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
  public void want(ComponentWant want) {
    arbitration.wantOwn(want);
  }

  @Override
  public void wantNoMore(String goalId, String whose) {
    arbitration.wantOwnNoMore(goalId);
  }

  @Override
  public void giveBack(String whose, Set<String> components) {
    arbitration.giveBackOwn(components);
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
