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
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.Clock;

/**
 * Gives each call its one answer, and gives it again when the same call comes again, so that
 * nothing is executed twice. It remembers a call for t, and at least for ten minutes. Clock thread
 * only.
 */
final class CallAnswers {

  private static final Duration SHORTEST_MEMORY = Duration.ofMinutes(10);
  private static final int MOST_REMEMBERED = 4096;

  /** What is known of a call that arrived. */
  enum Known {
    NEW,
    REPEATED,
    OTHER_BODY
  }

  private final String member;
  private final MemberVoice voice;
  private final MemberCondition condition;
  private final Clock clock;
  private final Map<Key, Remembered> remembered = new LinkedHashMap<>();

  CallAnswers(String member, MemberVoice voice, MemberCondition condition, Clock clock) {
    this.member = member;
    this.voice = voice;
    this.condition = condition;
    this.clock = clock;
  }

  /** Remembers a new call; answers a repeated one again if it was answered. */
  Known register(Call call) {
    forget();
    Key key = new Key(call);
    Remembered former = remembered.get(key);
    if (former == null) {
      Duration memory = max(call.timeout(), SHORTEST_MEMORY);
      remembered.put(key, new Remembered(call, clock.now().plus(memory), Optional.empty()));
      return Known.NEW;
    }
    if (!former.call.equals(call)) {
      return Known.OTHER_BODY;
    }
    former.answer.ifPresent(result -> voice.result(call.from(), result));
    return Known.REPEATED;
  }

  void succeeded(Call call, Map<String, Object> values) {
    answer(call, Outcome.SUCCEEDED, values, Optional.empty());
  }

  void rejected(Call call, ErrorCode code, String message) {
    answer(call, Outcome.REJECTED, Map.of(), Optional.of(error(code, message)));
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
    remembered.computeIfPresent(
        new Key(call),
        (key, known) -> new Remembered(known.call, known.until, Optional.of(result)));
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

  private void forget() {
    Iterator<Remembered> oldest = remembered.values().iterator();
    while (oldest.hasNext()) {
      boolean outdated = oldest.next().until.compareTo(clock.now()) < 0;
      if (outdated || remembered.size() >= MOST_REMEMBERED) {
        oldest.remove();
      }
    }
  }

  private static Duration max(Duration one, Duration other) {
    return one.compareTo(other) > 0 ? one : other;
  }

  private record Key(String from, String id) {
    private Key(Call call) {
      this(call.from(), call.id());
    }
  }

  private record Remembered(Call call, Duration until, Optional<Result> answer) {}
}
