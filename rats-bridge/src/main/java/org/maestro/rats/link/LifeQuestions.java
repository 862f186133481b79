package org.maestro.rats.link;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.Clock;

/**
 * Questions whether a life of a member is really over, before calls that run there are given up: on
 * an open site anybody may say so. Clock thread only.
 */
final class LifeQuestions {

  /** Wall time in which a life answers that is not over; a death is to be known within a second. */
  static final Duration ANSWER_LIMIT = Duration.ofMillis(700);

  private final String caller;
  private final OpenCalls calls;
  private final Supplier<String> nextCallId;
  private final Clock clock;
  private boolean ended;

  LifeQuestions(String caller, OpenCalls calls, Supplier<String> nextCallId, Clock clock) {
    this.caller = caller;
    this.calls = calls;
    this.nextCallId = nextCallId;
    this.clock = clock;
  }

  /**
   * Asks if calls run there.
   *
   * @param isAlive told once, later
   * @return whether it is asked
   */
  boolean ask(String member, String boot, Consumer<Boolean> isAlive) {
    if (ended || !calls.runsAt(member, boot)) {
      return false;
    }
    Duration limit = clock.ofWall(ANSWER_LIMIT);
    Question question = new Question(isAlive);
    clock.schedule(limit, caller, () -> question.answer(false));
    Call ping =
        new Call(
            nextCallId.get(),
            Optional.of(member),
            Optional.of(boot),
            ReservedFeature.PING.word(),
            Map.of(),
            limit,
            caller,
            Optional.empty());
    calls.begin(ping, Optional.of(boot), question::answered);
    return true;
  }

  /** Nobody waits for an answer any more. */
  void end() {
    ended = true;
  }

  private final class Question {
    private final Consumer<Boolean> isAlive;
    private boolean open = true;

    private Question(Consumer<Boolean> isAlive) {
      this.isAlive = isAlive;
    }

    /** Also who refuses is there; only another life says that this one is over. */
    private void answered(Result result) {
      Optional<ErrorCode> code = result.error().map(RatsError::code);
      boolean nobodySaidSo =
          code.filter(c -> c == ErrorCode.MEMBER_LOST || c == ErrorCode.BUS_UNAVAILABLE)
              .isPresent();
      if (!nobodySaidSo) {
        answer(code.filter(ErrorCode.RESTARTED::equals).isEmpty());
      }
    }

    private void answer(boolean alive) {
      if (open && !ended) {
        open = false;
        isAlive.accept(alive);
      }
    }
  }
}
