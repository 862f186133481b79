package org.maestro.rats.member;

import java.time.Duration;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.Clock;

/**
 * Gives each call its one answer, and gives it again when the same call comes again, so that
 * nothing is executed twice. It remembers a call until it is answered, and from then on for t, at
 * least for ten minutes: so long a controller may be away that asks for its calls again. Questions
 * have a memory of their own, so that many of them push out nothing that was done. Clock thread
 * only.
 */
final class CallAnswers {

  private static final Duration SHORTEST_MEMORY = Duration.ofMinutes(10);
  private static final int MOST_REMEMBERED = 4096;
  private static final Duration BETWEEN_FORGETTING = Duration.ofSeconds(10);

  /** The state of a call among those remembered, when it arrives. */
  enum Known {
    NEW,
    /** Its answer was sent again. */
    ANSWERED,
    /** It waits or runs; its answer comes at its end. */
    UNDERWAY,
    OTHER_BODY
  }

  private final String member;
  private final MemberPublisher voice;
  private final MemberCondition condition;
  private final Clock clock;
  private final Map<Key, Remembered> deeds = new LinkedHashMap<>();
  private final Map<Key, Remembered> questions = new LinkedHashMap<>();
  private Duration nextForgetting = Duration.ZERO;

  CallAnswers(String member, MemberPublisher voice, MemberCondition condition, Clock clock) {
    this.member = member;
    this.voice = voice;
    this.condition = condition;
    this.clock = clock;
  }

  /** Remembers a new call; answers a repeated one again if it was answered. */
  Known register(Call call) {
    Map<Key, Remembered> remembered = memoryFor(call);
    forget(remembered);
    Key key = new Key(call);
    Remembered former = deeds.getOrDefault(key, questions.get(key));
    if (former == null) {
      remembered.put(key, new Remembered(call, Optional.empty()));
      return Known.NEW;
    }
    if (!former.call.isAgain(call)) {
      return Known.OTHER_BODY;
    }
    former.answer.ifPresent(answer -> voice.result(call.from(), answer.result));
    return former.answer.isPresent() ? Known.ANSWERED : Known.UNDERWAY;
  }

  void succeeded(Call call, Map<String, Object> values) {
    answer(call, Outcome.SUCCEEDED, values, Optional.empty());
  }

  void rejected(Call call, ErrorCode code, String message) {
    answer(call, Outcome.REJECTED, Map.of(), Optional.of(error(code, message)));
  }

  void timedOut(Call call, String message) {
    answer(call, Outcome.TIMED_OUT, Map.of(), Optional.of(error(ErrorCode.TIMEOUT, message)));
  }

  /** A refusal that must not take the place of the answer to the first call of that id. */
  void rejectedUnremembered(String id, String caller, ErrorCode code, String message) {
    voice.result(
        caller,
        new Result(
            id,
            member,
            Outcome.REJECTED,
            condition.state(),
            Map.of(),
            Optional.of(error(code, message))));
  }

  void answer(Call call, Outcome outcome, Map<String, Object> values, Optional<RatsError> error) {
    Result result = new Result(call.id(), member, outcome, condition.state(), values, error);
    Duration until = clock.now().plus(max(call.timeout(), SHORTEST_MEMORY));
    memoryFor(call)
        .computeIfPresent(
            new Key(call),
            (key, known) -> new Remembered(known.call, Optional.of(new Answer(result, until))));
    voice.result(call.from(), result);
  }

  static RatsError error(ErrorCode code, String message) {
    boolean worthAnotherTry =
        switch (code) {
          case QUEUE_FULL, RESTARTED, EXPIRED, TIMEOUT, CANCELED, DISABLED -> true;
          default -> false;
        };
    return new RatsError(
        code, RatsError.Level.WARNING, message, Optional.empty(), List.of(), worthAnotherTry);
  }

  private Map<Key, Remembered> memoryFor(Call call) {
    return ReservedFeature.of(call.feature()).filter(ReservedFeature::isQuestion).isPresent()
        ? questions
        : deeds;
  }

  /** Now and then what is outdated, and as soon as there are too many the oldest. */
  private void forget(Map<Key, Remembered> remembered) {
    if (clock.now().compareTo(nextForgetting) >= 0) {
      nextForgetting = clock.now().plus(BETWEEN_FORGETTING);
      deeds.values().removeIf(this::isOutdated);
      questions.values().removeIf(this::isOutdated);
    }
    Iterator<Remembered> oldest = remembered.values().iterator();
    while (remembered.size() >= MOST_REMEMBERED && oldest.hasNext()) {
      if (oldest.next().answer.isPresent()) {
        oldest.remove();
      }
    }
  }

  private boolean isOutdated(Remembered known) {
    return known.answer.filter(answer -> answer.until.compareTo(clock.now()) < 0).isPresent();
  }

  private static Duration max(Duration one, Duration other) {
    return one.compareTo(other) > 0 ? one : other;
  }

  private record Key(String from, String id) {
    private Key(Call call) {
      this(call.from(), call.id());
    }
  }

  private record Remembered(Call call, Optional<Answer> answer) {}

  private record Answer(Result result, Duration until) {}
}
