package org.maestro.rats.conformance;

import static org.maestro.rats.conformance.Finding.broken;
import static org.maestro.rats.conformance.Finding.kept;
import static org.maestro.rats.conformance.Finding.notTried;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Map;
import java.util.Optional;

/** What a state says of calls that are over. */
final class PastCalls {

  private final Bench bench;

  PastCalls(Bench bench) {
    this.bench = bench;
  }

  /**
   * A state need not name them; one that does names the latest last.
   *
   * @param call which was made since then, and is over
   */
  Finding recent(int since, Map<String, Object> call) {
    String topic = bench.topics().state(bench.member());
    Optional<JsonNode> names =
        bench
            .examiner()
            .await(
                since,
                heard ->
                    heard.topic().equals(topic)
                        && heard
                            .content()
                            .path("recent")
                            .findValuesAsText("id")
                            .contains(call.get("id")),
                bench.patience().silence())
            .map(heard -> heard.content().path("recent"));
    if (names.isEmpty()) {
      boolean isSaid =
          bench.examiner().since(0).stream()
              .anyMatch(heard -> heard.topic().equals(topic) && heard.content().has("recent"));
      return isSaid
          ? broken(DeviceRule.RECENT, "its state has recent, but does not name a call that is over")
          : notTried(DeviceRule.RECENT, "its state has no recent, and need not");
    }
    return names.get().path(names.get().size() - 1).path("id").asText().equals(call.get("id"))
        ? kept(DeviceRule.RECENT, "the last in recent is the latest call")
        : broken(DeviceRule.RECENT, "the latest call is not the last in " + names.get());
  }
}
