package org.maestro.rats.conformance;

import static org.maestro.rats.conformance.Finding.broken;
import static org.maestro.rats.conformance.Finding.kept;
import static org.maestro.rats.conformance.Finding.notTried;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Whether prices are told, for each parameter set, and in time. */
final class PriceExamination {

  private static final Duration PRICE_WITHIN = Duration.ofMillis(50);

  /** A machine that does other things at the moment makes some answers late. */
  private static final int MOST_TRIES = 10;

  private final Dialogue dialogue;
  private final Optional<String> offered;
  private final Optional<FeatureCall> harmless;

  /**
   * @param offered a feature of which a price can be asked
   */
  PriceExamination(Dialogue dialogue, Optional<String> offered, Optional<FeatureCall> harmless) {
    this.dialogue = dialogue;
    this.offered = offered;
    this.harmless = harmless;
  }

  Finding cost() {
    JsonNode prices = prices();
    return prices.isMissingNode() ? none() : of(prices);
  }

  /** Of the first feature that it describes, for two parameter sets; missing when there is none. */
  private JsonNode prices() {
    return offered
        .flatMap(
            feature ->
                dialogue.result(
                    dialogue.call(
                        "$cost",
                        Map.of(
                            "feature",
                            feature,
                            "sets",
                            List.of(parametersOf(feature), parametersOf(feature))))))
        .map(result -> result.path("values").path("costs"))
        .orElse(MissingNode.getInstance());
  }

  private Map<String, Object> parametersOf(String feature) {
    return harmless
        .filter(call -> call.feature().equals(feature))
        .map(FeatureCall::parameters)
        .orElse(Map.of());
  }

  private Finding none() {
    return offered.isEmpty()
        ? notTried(DeviceRule.COST, "the description offers nothing that could be read")
        : broken(
            DeviceRule.COST,
            "$cost of %s is not answered with values.costs".formatted(offered.orElse("")));
  }

  private static Finding of(JsonNode costs) {
    if (!costs.isArray() || costs.size() != 2) {
      return broken(DeviceRule.COST, "for two parameter sets it answers " + costs);
    }
    for (JsonNode cost : costs) {
      if (!cost.path("cost").isNumber() && cost.path("reason").asText().isBlank()) {
        return broken(DeviceRule.COST, "%s is neither a cost nor a reason".formatted(cost));
      }
    }
    return kept(DeviceRule.COST, "two parameter sets get two answers: " + costs);
  }

  /** Against the same way without a question. */
  Finding inTime() {
    if (offered.isEmpty()) {
      return notTried(
          DeviceRule.PRICE_IN_TIME, "the description offers nothing that could be read");
    }
    long pinged = Long.MAX_VALUE;
    long asked = Long.MAX_VALUE;
    for (int times = 0; times < MOST_TRIES && !isInTime(pinged, asked); times++) {
      pinged = Math.min(pinged, millis(() -> dialogue.result(dialogue.ping())));
      asked = Math.min(asked, millis(this::prices));
    }
    String seen = "$cost took %d ms, $ping %d ms".formatted(asked, pinged);
    return isInTime(pinged, asked)
        ? kept(DeviceRule.PRICE_IN_TIME, seen)
        : broken(DeviceRule.PRICE_IN_TIME, seen);
  }

  private static boolean isInTime(long pingedMillis, long askedMillis) {
    return askedMillis != Long.MAX_VALUE && askedMillis - pingedMillis <= PRICE_WITHIN.toMillis();
  }

  private static long millis(Runnable work) {
    long began = System.nanoTime();
    work.run();
    return Duration.ofNanos(System.nanoTime() - began).toMillis();
  }
}
