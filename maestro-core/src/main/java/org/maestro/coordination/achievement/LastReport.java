package org.maestro.coordination.achievement;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.planning.api.StepKey;

/** A dispatcher that remembers how the last call ended. */
final class LastReport implements ActionDispatcher {
  private final ActionDispatcher dispatcher;
  private Optional<Report> last = Optional.empty();

  LastReport(ActionDispatcher dispatcher) {
    this.dispatcher = dispatcher;
  }

  Optional<Report> last() {
    return last;
  }

  @Override
  public Handle perform(Request order, Consumer<Report> reported) {
    return dispatcher.perform(
        order,
        report -> {
          last = Optional.of(report);
          reported.accept(report);
        });
  }

  @Override
  public void ask(String member, Runnable heard) {
    dispatcher.ask(member, heard);
  }

  @Override
  public void callOff(String member, Call call) {
    dispatcher.callOff(member, call);
  }

  @Override
  public void alive(String goalId, String member, String feature) {
    dispatcher.alive(goalId, member, feature);
  }

  @Override
  public boolean isOwed(String goalId, StepKey step) {
    return dispatcher.isOwed(goalId, step);
  }

  @Override
  public List<Request> giveUpOwed(String goalId, Predicate<StepKey> unwanted) {
    return dispatcher.giveUpOwed(goalId, unwanted);
  }
}
