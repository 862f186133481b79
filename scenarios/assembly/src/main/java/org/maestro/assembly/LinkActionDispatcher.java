package org.maestro.assembly;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.members.CallReporter;
import org.maestro.planning.api.Step;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.Outcome;
import org.maestro.sl.Term;

/** Orders straight as calls on the bus. */
final class LinkActionDispatcher implements ActionDispatcher {
  private final Deputies deputies;
  private final RatsLink link;
  private long lastOrder;

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
    String conversation = String.valueOf(++lastOrder);
    deputy.get().view().begun(conversation, step.bindings());
    Performing performing = new Performing(deputy.get(), step, conversation, reported);
    RatsLink.Order worded =
        new RatsLink.Order(
            order.call().map(Call::id),
            step.member(),
            order.call().flatMap(Call::life),
            step.feature().name(),
            LinkContractNet.json(order.parameters()),
            order.timeout(),
            Optional.of(order.goalId()));
    CallReporter reporter =
        new CallReporter(action -> deputies.later(step.member(), action), performing);
    RatsLink.CallHandle call =
        order.ends() ? link.end(worded, reporter) : link.call(worded, reporter);
    performing.callId = call.callId();
    return call::cancel;
  }

  @Override
  public void callOff(String member, Call call) {
    call.life().ifPresent(boot -> link.cancel(member, boot, call.id()));
  }

  /** What becomes of one order. */
  private static final class Performing implements CallReporter.Listener {
    private final Deputies.Deputy deputy;
    private final Step step;
    private final String conversation;
    private final Consumer<Report> reported;
    private String callId = "";

    Performing(Deputies.Deputy deputy, Step step, String conversation, Consumer<Report> reported) {
      this.deputy = deputy;
      this.step = step;
      this.conversation = conversation;
      this.reported = reported;
    }

    @Override
    public void reported(Outcome outcome, Report report) {
      reported.accept(
          report.with(
              deputy.view().account(conversation, callId, step.feature(), report.succeeded())));
      deputy.view().over().ifPresent(deputy::said);
    }

    @Override
    public void learnt(Map<String, Term> outputs) {
      deputy.learnt(step.feature(), step.bindings(), outputs);
    }

    @Override
    public void over() {
      deputy.view().forget(conversation);
    }
  }
}
