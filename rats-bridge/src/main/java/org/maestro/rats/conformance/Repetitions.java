package org.maestro.rats.conformance;

import static org.maestro.rats.conformance.Finding.broken;
import static org.maestro.rats.conformance.Finding.kept;
import static org.maestro.rats.conformance.Finding.notTried;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Whether a device does once what is said once, and nothing of what was said to another life. */
final class Repetitions {

  private static final int MANY = 100;

  private final Bench bench;
  private final Dialogue dialogue;
  private final Optional<FeatureCall> harmless;
  private final String boot;
  private Optional<Answered> first = Optional.empty();

  private record Answered(Map<String, Object> call, JsonNode result, long atNanos) {}

  Repetitions(Bench bench, Optional<FeatureCall> harmless, String boot) {
    this.bench = bench;
    this.dialogue = bench.dialogue();
    this.harmless = harmless;
    this.boot = boot;
  }

  List<Finding> findings() {
    return List.of(sameCall(), otherBody(), otherBoot(), retainedCall(), manyCalls());
  }

  private Finding sameCall() {
    if (harmless.isEmpty()) {
      return notTried(DeviceRule.SAME_CALL, "no feature was named that may be called");
    }
    Map<String, Object> call = bench.call(harmless.get());
    Optional<JsonNode> result = dialogue.result(call);
    first = result.map(answer -> new Answered(call, answer, System.nanoTime()));
    return first.isEmpty()
        ? broken(DeviceRule.SAME_CALL, harmless.get().feature() + " is not answered")
        : again(DeviceRule.SAME_CALL, "the same answer twice: " + Dialogue.outcome(result));
  }

  /** At the end, when many calls have come since. */
  Finding remembered() {
    return first
        .map(
            answered ->
                again(
                    DeviceRule.REMEMBERED,
                    "the answer to a call of %d s ago, and many calls since, is the same"
                        .formatted(
                            Duration.ofNanos(System.nanoTime() - answered.atNanos).toSeconds())))
        .orElseGet(
            () -> notTried(DeviceRule.REMEMBERED, "no call was answered that could be repeated"));
  }

  private Finding again(DeviceRule rule, String when) {
    Answered before = first.orElseThrow();
    Optional<JsonNode> second = dialogue.result(before.call);
    if (second.isEmpty()) {
      return broken(rule, "the same call again is not answered");
    }
    return before.result.equals(second.get())
        ? kept(rule, when)
        : broken(rule, "first %s, then %s".formatted(before.result, second.get()));
  }

  private Finding otherBody() {
    String id = bench.examiner().newId();
    dialogue.result(bench.examiner().call(id, "$ping", Map.of()));
    return dialogue.refused(
        DeviceRule.OTHER_BODY,
        bench.examiner().call(id, "$ping", Map.of("another", true)),
        "DUPLICATE_ID",
        "the id of another call");
  }

  private Finding otherBoot() {
    Map<String, Object> call = dialogue.ping();
    call.put("boot", "never-" + boot);
    return dialogue.refused(DeviceRule.OTHER_BOOT, call, "RESTARTED", "a call for another boot");
  }

  private Finding retainedCall() {
    Map<String, Object> call = dialogue.ping();
    Examiner examiner = bench.examiner();
    String topic = bench.topics().call(examiner.name());
    int since = examiner.now();
    examiner.sendRetained(topic, examiner.bytes(call));
    Optional<JsonNode> result = dialogue.result(since, call, bench.patience().silence());
    examiner.sendRetained(topic, new byte[0]);
    return result.isEmpty()
        ? kept(DeviceRule.RETAINED_CALL, "a retained $ping is not answered")
        : broken(DeviceRule.RETAINED_CALL, "a retained $ping is answered");
  }

  private Finding manyCalls() {
    int since = bench.examiner().now();
    List<Map<String, Object>> calls = new ArrayList<>();
    for (int number = 0; number < MANY; number++) {
      Map<String, Object> call = dialogue.ping();
      calls.add(call);
      bench.examiner().send(call);
      if (number % 3 == 0) {
        bench.examiner().send(call);
      }
    }
    int answered = answered(since, calls);
    String seen =
        "%d of %d calls, a third of them sent twice, were answered".formatted(answered, MANY);
    return answered == MANY
        ? kept(DeviceRule.MANY_CALLS, seen)
        : broken(DeviceRule.MANY_CALLS, seen);
  }

  /** How many are answered before none more is for as long as an answer may take. */
  private int answered(int since, List<Map<String, Object>> calls) {
    List<Map<String, Object>> left = new ArrayList<>(calls);
    boolean silent = false;
    while (!left.isEmpty() && !silent) {
      silent =
          bench
              .examiner()
              .await(
                  since,
                  heard -> left.stream().anyMatch(call -> dialogue.isResult(heard, call)),
                  bench.patience().answersWithin())
              .isEmpty();
      left.removeIf(call -> dialogue.result(since, call, Duration.ZERO).isPresent());
    }
    return calls.size() - left.size();
  }
}
