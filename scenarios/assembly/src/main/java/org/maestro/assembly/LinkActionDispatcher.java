package org.maestro.assembly;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.members.CallReporter;
import org.maestro.members.MemberOrders;
import org.maestro.planning.api.Step;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.Outcome;
import org.maestro.sl.Term;

/** Orders straight as calls on the bus. */
final class LinkActionDispatcher implements ActionDispatcher {
  private final Deputies deputies;
  private final RatsLink link;

  LinkActionDispatcher(Deputies deputies, RatsLink link) {
    this.deputies = deputies;
    this.link = link;
  }

  @Override
  public Handle perform(Request order, Consumer<Report> reported) {
    Step step = order.step();
    Optional<Deputies.Deputy> deputy = deputies.of(step.member());
    if (deputy.isEmpty()) {
      Report absent =
          new Report(false, Map.of(), Optional.of(step.member() + " is not there"), List.of());
      deputies.later(step.member(), () -> reported.accept(absent));
      return () -> {};
    }
    MemberOrders.Order worded =
        new MemberOrders.Order(
            step.feature(),
            order.parameters(),
            order.timeout(),
            order.call().map(Call::id),
            order.call().flatMap(Call::life),
            Optional.of(order.goalId()),
            Optional.empty(),
            order.ends());
    return deputy.get().orders().begin(worded, new Performing(deputy.get(), step, reported))
        ::cancel;
  }

  @Override
  public void ask(String member, Runnable heard) {
    deputies
        .of(member)
        .ifPresentOrElse(
            deputy -> deputy.orders().tellAgain(heard), () -> deputies.later(member, heard));
  }

  @Override
  public void callOff(String member, Call call) {
    call.life().ifPresent(boot -> link.cancel(member, boot, call.id()));
  }

  /** The listener to one order. */
  private record Performing(Deputies.Deputy deputy, Step step, Consumer<Report> reported)
      implements CallReporter.Listener {
    @Override
    public void reported(Outcome outcome, Report report) {
      reported.accept(report);
    }

    @Override
    public void learnt(Map<String, Term> outputs) {
      deputy.learnt(step.feature(), step.bindings(), outputs);
    }

    @Override
    public void over() {
      // Nothing is kept of it here.
    }
  }
}
