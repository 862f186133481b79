package org.maestro.rats.conformance;

import static org.maestro.rats.conformance.Finding.broken;
import static org.maestro.rats.conformance.Finding.kept;
import static org.maestro.rats.conformance.Finding.notTried;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Whether a device takes fresh calls, whatever the clocks of their callers show. */
final class SentTimes {

  private static final long FAR_MILLIS = 4_000_000_000_000L;
  private static final long AN_HOUR_MILLIS = 3_600_000;

  private final Bench bench;
  private final Optional<FeatureCall> harmless;

  SentTimes(Bench bench, Optional<FeatureCall> harmless) {
    this.bench = bench;
    this.harmless = harmless;
  }

  List<Finding> findings() {
    if (harmless.isEmpty()) {
      String why = "no feature was named that may be called";
      return List.of(notTried(DeviceRule.CLOCKS, why), notTried(DeviceRule.NOT_OLDER, why));
    }
    Optional<JsonNode> behind = result("clock-behind", 1);
    Optional<JsonNode> ahead = result("clock-ahead", FAR_MILLIS);
    Optional<JsonNode> further = result("clock-ahead", FAR_MILLIS + AN_HOUR_MILLIS);
    return List.of(
        isTaken(behind) && isTaken(ahead)
            ? kept(DeviceRule.CLOCKS, "calls by clocks that are far behind and ahead are taken")
            : broken(
                DeviceRule.CLOCKS,
                "a call by a clock far behind is %s, and one by a clock far ahead %s"
                    .formatted(said(behind), said(ahead))),
        isTaken(further)
            ? kept(DeviceRule.NOT_OLDER, "a call that was quicker than the one before is taken")
            : broken(
                DeviceRule.NOT_OLDER,
                "a call that was quicker than the one before is " + said(further)));
  }

  private Optional<JsonNode> result(String clock, long millis) {
    Map<String, Object> call = bench.call(harmless.orElseThrow());
    call.put("sent", Map.of("clock", clock, "ms", millis));
    return bench.dialogue().result(call);
  }

  private static boolean isTaken(Optional<JsonNode> result) {
    return result.isPresent() && !code(result).equals("EXPIRED");
  }

  private static String said(Optional<JsonNode> result) {
    return result.isEmpty()
        ? "not answered"
        : (Dialogue.outcome(result) + " " + code(result)).trim();
  }

  private static String code(Optional<JsonNode> result) {
    return result.map(node -> node.path("error").path("code").asText()).orElse("");
  }
}
