package org.maestro.rats.conformance;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;

/** What a flawed device does when it is called. One thread. */
final class FlawedCalls {
  private static final int RING_MILLIS = 300;
  private static final int LATE_MILLIS = 1_500;
  private static final int FEW = 20;
  private static final long AN_HOUR_MILLIS = 3_600_000;

  private final Flaw flaw;
  private final ScheduledExecutorService thread;
  private final Runnable announce;
  private final Runnable tellState;
  private final BiConsumer<JsonNode, Answer> send;
  private final Map<String, JsonNode> bodies = new LinkedHashMap<>();
  private final Map<String, Answer> answers = new LinkedHashMap<>();
  private final Map<String, Long> latest = new LinkedHashMap<>();
  private final Deque<JsonNode> underWay = new ArrayDeque<>();
  private final List<Map<String, String>> recent = new ArrayList<>();
  private int begun;
  private int rung;

  /** What a result says beside whose it is. */
  record Answer(String outcome, Map<String, Object> values, Optional<Map<String, Object>> error) {}

  FlawedCalls(
      Flaw flaw,
      ScheduledExecutorService thread,
      Runnable announce,
      Runnable tellState,
      BiConsumer<JsonNode, Answer> send) {
    this.flaw = flaw;
    this.thread = thread;
    this.announce = announce;
    this.tellState = tellState;
    this.send = send;
  }

  List<Map<String, String>> recent() {
    return recent;
  }

  void take(JsonNode call) {
    String key = key(call);
    if (bodies.containsKey(key)
        && !bodies.get(key).equals(call.path("p"))
        && flaw != Flaw.TAKES_ANY_BODY) {
      refuse(call, "DUPLICATE_ID", "another body");
    } else if (answers.containsKey(key) && flaw != Flaw.DOES_TWICE) {
      send.accept(call, answers.get(key));
    } else {
      bodies.put(key, call.path("p"));
      perform(call);
    }
  }

  private static String key(JsonNode call) {
    return call.path("from").asText() + " " + call.path("id").asText();
  }

  private void perform(JsonNode call) {
    switch (call.path("f").asText()) {
      case "ring" -> ring(call);
      case "$cancel" -> cancel(call);
      case "$safe" -> safe(call);
      case "$cost" -> {
        pause();
        Map<String, Object> price = Map.of("cost", 1, "seconds", 1);
        done(
            call,
            Map.of("costs", flaw == Flaw.PRICES_ONE_SET ? List.of(price) : List.of(price, price)));
      }
      case "$describe" -> {
        if (flaw != Flaw.DESCRIBES_NOTHING_AGAIN) {
          announce.run();
        }
        done(call, Map.of());
      }
      default -> done(call, Map.of());
    }
  }

  /** One after the other. */
  private void ring(JsonNode call) {
    if (isTakenForLate(call)) {
      refuse(call, "EXPIRED", "it is too late");
      return;
    }
    underWay.add(call);
    if (flaw != Flaw.COUNTS_NO_TIME_IN_ITS_QUEUE) {
      endInTime(call);
    }
    if (underWay.size() == 1) {
      begin(call);
    }
  }

  private void begin(JsonNode call) {
    if (flaw == Flaw.COUNTS_NO_TIME_IN_ITS_QUEUE) {
      endInTime(call);
    }
    begun++;
    boolean isSlow = flaw == Flaw.IS_SLOW_ONCE && begun == 2;
    thread.schedule(() -> rings(call), isSlow ? LATE_MILLIS : RING_MILLIS, TimeUnit.MILLISECONDS);
  }

  private void endInTime(JsonNode call) {
    if (flaw != Flaw.IS_NEVER_TOO_LATE) {
      thread.schedule(
          () -> end(call, "TIMED_OUT", "TIMEOUT"), call.path("t").asLong(), TimeUnit.MILLISECONDS);
    }
  }

  private void rings(JsonNode call) {
    if (underWay.contains(call)) {
      rung++;
      over(call, new Answer("SUCCEEDED", Map.of("times", rung), Optional.empty()));
    }
  }

  private void end(JsonNode call, String outcome, String code) {
    if (underWay.contains(call)) {
      over(call, new Answer(outcome, Map.of(), Optional.of(error(code, "it was ended"))));
    }
  }

  private void over(JsonNode call, Answer answer) {
    boolean wasRunning = call.equals(underWay.peek());
    underWay.remove(call);
    recent.add(
        flaw == Flaw.NAMES_THE_LATEST_FIRST ? 0 : recent.size(),
        Map.of("id", call.path("id").asText(), "outcome", answer.outcome()));
    if (flaw == Flaw.TELLS_ITS_STATE_LATE) {
      thread.schedule(tellState, LATE_MILLIS, TimeUnit.MILLISECONDS);
    } else {
      tellState.run();
    }
    remember(call, answer);
    send.accept(call, answer);
    if (wasRunning && !underWay.isEmpty()) {
      begin(underWay.element());
    }
  }

  private boolean isTakenForLate(JsonNode call) {
    JsonNode sent = call.path("sent");
    if (sent.isMissingNode()) {
      return false;
    }
    long millis = sent.path("ms").asLong();
    Long before = latest.put(sent.path("clock").asText(), millis);
    return flaw == Flaw.WANTS_CLOCKS_TO_AGREE
            && Math.abs(millis - System.currentTimeMillis()) > AN_HOUR_MILLIS
        || flaw == Flaw.TAKES_QUICK_CALLS_FOR_LATE
            && before != null
            && Math.abs(millis - before) > AN_HOUR_MILLIS / 2;
  }

  private void cancel(JsonNode call) {
    Optional<JsonNode> meant =
        underWay.stream()
            .filter(one -> one.path("id").equals(call.path("p").path("id")))
            .filter(one -> flaw != Flaw.CANCELS_NOTHING)
            .findFirst();
    meant.ifPresent(one -> end(one, "CANCELED", "CANCELED"));
    done(call, Map.of("found", meant.isPresent() || flaw == Flaw.FINDS_WHAT_NEVER_WAS));
  }

  private void safe(JsonNode call) {
    if (flaw == Flaw.IS_NEVER_SAFE) {
      refuse(call, "DISABLED", "never");
      return;
    }
    if (flaw != Flaw.GOES_ON_WHEN_SAFE) {
      List.copyOf(underWay).forEach(one -> end(one, "CANCELED", "CANCELED"));
    }
    done(call, Map.of());
  }

  /** Real slowness, which the examiner is to see. */
  private void pause() {
    if (flaw == Flaw.PRICES_SLOWLY) {
      try {
        Thread.sleep(150);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }

  private void done(JsonNode call, Map<String, Object> values) {
    Answer answer = new Answer("SUCCEEDED", values, Optional.empty());
    remember(call, answer);
    send.accept(call, answer);
  }

  private void remember(JsonNode call, Answer answer) {
    answers.put(key(call), answer);
    if (flaw == Flaw.FORGETS_SOON && answers.size() > FEW) {
      answers.remove(answers.keySet().iterator().next());
    }
  }

  /** Does not take the place of an answer. */
  void refuse(JsonNode call, String code, String message) {
    send.accept(call, new Answer("REJECTED", Map.of(), Optional.of(error(code, message))));
  }

  private Map<String, Object> error(String code, String message) {
    Map<String, Object> error = new LinkedHashMap<>();
    error.put("code", code);
    error.put("level", "WARNING");
    error.put("message", message);
    error.put("refs", List.of());
    if (flaw != Flaw.ERROR_WITHOUT_RETRIABLE) {
      error.put("retriable", false);
    }
    return error;
  }
}
