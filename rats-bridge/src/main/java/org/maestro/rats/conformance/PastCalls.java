package org.maestro.rats.conformance;

import static org.maestro.rats.conformance.Finding.broken;
import static org.maestro.rats.conformance.Finding.kept;
import static org.maestro.rats.conformance.Finding.notTried;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
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
    Optional<JsonNode> names = names(since, call, bench.patience().silence());
    if (names.isEmpty() && !isSaid()) {
      return notTried(DeviceRule.RECENT, "its state has no recent, and need not");
    }
    names = names.or(() -> names(since, call, bench.patience().answersWithin()));
    if (names.isEmpty()) {
      return broken(
          DeviceRule.RECENT, "its state has recent, but does not name a call that is over");
    }
    return names.get().path(names.get().size() - 1).path("id").asText().equals(call.get("id"))
        ? kept(DeviceRule.RECENT, "the last in recent is the latest call")
        : broken(DeviceRule.RECENT, "the latest call is not the last in " + names.get());
  }

  private Optional<JsonNode> names(int since, Map<String, Object> call, Duration atMost) {
    return bench
        .examiner()
        .await(
            since,
            heard ->
                isState(heard)
                    && heard
                        .content()
                        .path("recent")
                        .findValuesAsText("id")
                        .contains(call.get("id")),
            atMost)
        .map(heard -> heard.content().path("recent"));
  }

  private boolean isSaid() {
    return bench.examiner().since(0).stream()
        .anyMatch(heard -> isState(heard) && heard.content().has("recent"));
  }

  private boolean isState(Examiner.Heard heard) {
    return heard.topic().equals(bench.topics().state(bench.member()));
  }
}
