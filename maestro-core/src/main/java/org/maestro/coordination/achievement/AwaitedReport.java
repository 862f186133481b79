package org.maestro.coordination.achievement;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Sentences;
import org.maestro.rats.time.Clock;

/**
 * A step's report, awaited once and not for ever: a member that never answers loses what the step
 * had, and its goal goes on without it.
 */
final class AwaitedReport {
  private final Ports ports;
  private Optional<Consumer<ActionDispatcher.Report>> then;
  private Optional<Clock.Timer> timer = Optional.empty();

  AwaitedReport(Ports ports, Consumer<ActionDispatcher.Report> then) {
    this.ports = ports;
    this.then = Optional.of(then);
  }

  /**
   * Waits no longer than this, by the clock, since the member was told or said the last time that
   * it is at it still. Then the call is called off, since its member may be at it all the same.
   */
  void until(Duration longest, String member, ActionDispatcher.Handle call) {
    if (then.isPresent()) {
      ActionDispatcher.Report none =
          new ActionDispatcher.Report(
              false,
              Map.of(),
              Optional.of(
                  member
                      + " has not answered for "
                      + Sentences.number(longest.toMillis() / 1000.0)
                      + " s"),
              List.of());
      timer =
          Optional.of(
              ports
                  .clock()
                  .schedule(
                      longest,
                      member,
                      () -> ports.owner().execute(() -> silent(none, longest, member, call))));
    }
  }

  private void silent(
      ActionDispatcher.Report none, Duration longest, String member, ActionDispatcher.Handle call) {
    if (then.isEmpty()) {
      return;
    }
    Duration now = ports.clock().now();
    Optional<Duration> left =
        call.aliveAt().map(at -> at.plus(longest).minus(now)).filter(more -> !more.isNegative());
    if (left.isPresent()) {
      until(left.get().plusMillis(1), member, call);
    } else {
      call.cancel();
      arrived(none);
    }
  }

  void arrived(ActionDispatcher.Report report) {
    timer.ifPresent(Clock.Timer::cancel);
    Optional<Consumer<ActionDispatcher.Report>> first = then;
    then = Optional.empty();
    first.ifPresent(consumer -> consumer.accept(report));
  }
}
