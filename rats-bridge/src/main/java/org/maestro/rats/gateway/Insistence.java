package org.maestro.rats.gateway;

import java.time.Duration;
import java.util.Optional;
import org.maestro.rats.time.Clock;

/**
 * Asks until there is an answer: each pause is twice the one before, up to a longest one, so that
 * who never answers costs little. Clock thread only.
 */
final class Insistence {

  private final String owner;
  private final Runnable question;
  private final Duration shortest;
  private final Duration longest;
  private final Clock clock;
  private Optional<Clock.Timer> next = Optional.empty();

  /**
   * @param shortest the first pause
   */
  Insistence(String owner, Runnable question, Duration shortest, Duration longest, Clock clock) {
    this.owner = owner;
    this.question = question;
    this.shortest = shortest;
    this.longest = longest;
    this.clock = clock;
  }

  /** Asks now, unless it is at it already. */
  void begin() {
    if (next.isEmpty()) {
      ask(shortest);
    }
  }

  /** The same, but asks first when the shortest pause has passed. */
  void beginAfterPause() {
    if (next.isEmpty()) {
      pause(shortest);
    }
  }

  /** The answer has come, or is not wanted any more. */
  void end() {
    next.ifPresent(Clock.Timer::cancel);
    next = Optional.empty();
  }

  private void ask(Duration pause) {
    question.run();
    pause(pause);
  }

  private void pause(Duration pause) {
    Duration twice = pause.multipliedBy(2);
    Duration following = twice.compareTo(longest) > 0 ? longest : twice;
    next = Optional.of(clock.schedule(pause, owner, () -> ask(following)));
  }
}
