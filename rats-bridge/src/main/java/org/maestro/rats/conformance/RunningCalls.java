package org.maestro.rats.conformance;

import static org.maestro.rats.conformance.Finding.broken;
import static org.maestro.rats.conformance.Finding.kept;
import static org.maestro.rats.conformance.Finding.notTried;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * What becomes of a call while it runs or waits: whether it ends with its time, when it is
 * canceled, and when the device is to be safe. Needs a feature that may be called and takes some
 * time.
 */
final class RunningCalls {

  /** In less the examiner's own word comes too late to end it. */
  private static final Duration SHORTEST = Duration.ofMillis(100);

  private static final int MOST_TRIES = 3;

  private final Bench bench;
  private final Dialogue dialogue;
  private final Optional<FeatureCall> harmless;

  RunningCalls(Bench bench, Optional<FeatureCall> harmless) {
    this.bench = bench;
    this.dialogue = bench.dialogue();
    this.harmless = harmless;
  }

  List<Finding> findings() {
    if (harmless.isEmpty()) {
      return without("no feature was named that may be called");
    }
    int since = bench.examiner().now();
    Made usual = made();
    if (!usual.outcome().equals("SUCCEEDED")) {
      return without("%s is %s".formatted(harmless.get().feature(), usual.outcome()));
    }
    Finding recent = new PastCalls(bench).recent(since, usual.call());
    if (usual.took().compareTo(SHORTEST) < 0) {
      String soon =
          "%s is done in %d ms, too soon to be ended before"
              .formatted(harmless.get().feature(), usual.took().toMillis());
      return Stream.concat(
              Stream.of(recent, neverWas(), dialogue.succeeds(DeviceRule.SAFE, "$safe")),
              Stream.of(DeviceRule.TIME_IN_QUEUE, DeviceRule.TIME_WHEN_RUNNING)
                  .map(rule -> notTried(rule, soon)))
          .toList();
    }
    return List.of(
        recent,
        atBest(usual, this::timeWhenRunning),
        atBest(usual, this::timeInQueue),
        atBest(usual, this::canceled),
        atBest(usual, this::safe));
  }

  private List<Finding> without(String why) {
    return Stream.concat(
            Stream.of(neverWas(), dialogue.succeeds(DeviceRule.SAFE, "$safe")),
            Stream.of(DeviceRule.RECENT, DeviceRule.TIME_IN_QUEUE, DeviceRule.TIME_WHEN_RUNNING)
                .map(rule -> notTried(rule, why)))
        .toList();
  }

  private Made made() {
    return made(bench.call(harmless.orElseThrow()), () -> {});
  }

  /** Makes the call, does that, and waits for the call's result. */
  private Made made(Map<String, Object> call, Runnable then) {
    int since = bench.examiner().now();
    long began = System.nanoTime();
    bench.examiner().send(call);
    then.run();
    Optional<JsonNode> result =
        dialogue.result(since, call, bench.patience().answersWithin().multipliedBy(2));
    return new Made(call, result, Duration.ofNanos(System.nanoTime() - began));
  }

  private Map<String, Object> shortCall(Made usual) {
    Map<String, Object> call = bench.call(harmless.orElseThrow());
    call.put("t", Math.max(1, usual.took().toMillis() / 4));
    return call;
  }

  /** A machine that does other things at the moment makes some words late, and some calls long. */
  private Finding atBest(Made first, Function<Made, Finding> trial) {
    Made usual = first;
    Finding found = trial.apply(usual);
    for (int times = 1; times < MOST_TRIES && found.verdict() != Finding.Verdict.KEPT; times++) {
      usual = usual.orQuicker(made());
      found = trial.apply(usual);
    }
    return found;
  }

  private Finding timeWhenRunning(Made usual) {
    Made made = made(shortCall(usual), () -> {});
    if (made.wasDoneSooner(usual)) {
      return notTried(DeviceRule.TIME_WHEN_RUNNING, made.doneSooner());
    }
    String seen =
        "with a t of %s ms a call that takes %d ms is %s"
            .formatted(made.call().get("t"), usual.took().toMillis(), made.outcome());
    return made.outcome().equals("TIMED_OUT")
        ? kept(DeviceRule.TIME_WHEN_RUNNING, seen)
        : broken(DeviceRule.TIME_WHEN_RUNNING, seen);
  }

  /** Behind another of the same feature, whether it has to wait for that or not. */
  private Finding timeInQueue(Made usual) {
    Map<String, Object> behind = shortCall(usual);
    int since = bench.examiner().now();
    Made before = made(bench.call(harmless.orElseThrow()), () -> bench.examiner().send(behind));
    int ended = bench.examiner().now();
    Optional<JsonNode> result =
        dialogue.result(since, behind, bench.patience().answersWithin().multipliedBy(2));
    boolean isInTime =
        bench.examiner().since(since).stream()
            .limit(ended - since)
            .anyMatch(heard -> dialogue.isResult(heard, behind));
    String seen =
        "behind another, a call with a t of %s ms is %s, %s that one is %s"
            .formatted(
                behind.get("t"),
                result.isEmpty() ? "not answered" : Dialogue.outcome(result),
                isInTime ? "before" : "after",
                before.outcome());
    if (Dialogue.outcome(result).equals("SUCCEEDED") && before.wasDoneSooner(usual)) {
      return notTried(DeviceRule.TIME_IN_QUEUE, before.doneSooner());
    }
    return isInTime && !Dialogue.outcome(result).equals("SUCCEEDED")
        ? kept(DeviceRule.TIME_IN_QUEUE, seen)
        : broken(DeviceRule.TIME_IN_QUEUE, seen);
  }

  private Finding canceled(Made usual) {
    Finding never = neverWas();
    if (never.verdict() != Finding.Verdict.KEPT) {
      return never;
    }
    Map<String, Object> call = bench.call(harmless.orElseThrow());
    Map<String, Object> cancel = dialogue.call("$cancel", Map.of("id", call.get("id")));
    int since = bench.examiner().now();
    Made made = made(call, () -> bench.examiner().send(cancel));
    if (made.wasDoneSooner(usual)) {
      return kept(DeviceRule.CANCEL, never.why());
    }
    String seen =
        "a call that is canceled while it runs is %s, and $cancel says %s"
            .formatted(
                made.outcome(),
                dialogue
                    .result(since, cancel, bench.patience().answersWithin())
                    .map(answer -> answer.path("values").toString())
                    .orElse("nothing"));
    return made.outcome().equals("CANCELED") && seen.contains("\"found\":true")
        ? kept(DeviceRule.CANCEL, seen)
        : broken(DeviceRule.CANCEL, seen);
  }

  private Finding neverWas() {
    Optional<JsonNode> result =
        dialogue.result(dialogue.call("$cancel", Map.of("id", "never-was")));
    JsonNode found = result.map(node -> node.path("values").path("found")).orElse(null);
    if (result.isEmpty()) {
      return broken(DeviceRule.CANCEL, "$cancel is not answered");
    }
    return found != null && found.isBoolean() && !found.booleanValue()
        ? kept(DeviceRule.CANCEL, "of a call that never was it says that it was not found")
        : broken(
            DeviceRule.CANCEL,
            "of a call that never was it says %s; {\"found\": false} is right"
                .formatted(result.get().path("values")));
  }

  private Finding safe(Made usual) {
    Map<String, Object> safe = dialogue.call("$safe", Map.of());
    int since = bench.examiner().now();
    Made made = made(bench.call(harmless.orElseThrow()), () -> bench.examiner().send(safe));
    Optional<JsonNode> result = dialogue.result(since, safe, bench.patience().answersWithin());
    String seen =
        "$safe is %s, and a call that ran then is %s"
            .formatted(
                result.isEmpty() ? "not answered" : Dialogue.outcome(result), made.outcome());
    boolean isEnded =
        made.result().isPresent()
            && (!made.outcome().equals("SUCCEEDED") || made.wasDoneSooner(usual));
    return isEnded && Dialogue.outcome(result).equals("SUCCEEDED")
        ? kept(DeviceRule.SAFE, seen)
        : broken(DeviceRule.SAFE, seen);
  }
}
