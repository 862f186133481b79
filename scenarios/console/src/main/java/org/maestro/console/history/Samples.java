package org.maestro.console.history;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.StringJoiner;

/** The samples of series that are in an entry. */
final class Samples {
  /** How many goals there are, by these states. */
  private static final Map<String, List<String>> GOALS =
      Map.of(
          "goals-under-way",
          List.of("submitted", "planning", "running", "replanning", "confirming"),
          "goals-waiting",
          List.of("waiting", "suspended"),
          "goals-reached",
          List.of("achieved", "holding"),
          "goals-failed",
          List.of("failed"));

  private Samples() {}

  /** Takes the entry into the state; returns its samples, by the names of their series. */
  static Map<String, Sample> taken(Entry entry, PastState state) {
    Map<String, Sample> samples = new HashMap<>();
    long at = entry.at().toEpochMilli();
    entry
        .told()
        .path("gone")
        .forEach(
            name ->
                state
                    .facts()
                    .find(name.asText())
                    .flatMap(Samples::series)
                    .ifPresent(series -> samples.put(series, Sample.unknown(at))));
    state.take(entry);
    switch (entry.kind()) {
      case STATE -> {
        numbers(entry.told().path("facts"), at, samples);
        goals(state, at, samples);
      }
      case FACTS -> numbers(entry.told().path("set"), at, samples);
      case GOALS -> goals(state, at, samples);
      case FIGURES ->
          entry
              .told()
              .properties()
              .forEach(figure -> samples.put(figure.getKey(), figure(figure, at)));
      case HOME, AGENTS, HAPPENING -> {
        // There are no numbers in them.
      }
    }
    return samples;
  }

  /** The name of the series that a fact belongs to, when it tells a number. */
  private static Optional<String> series(JsonNode fact) {
    if (!fact.path("value").isNumber()) {
      return Optional.empty();
    }
    StringJoiner fluent = new StringJoiner(" ", "(", ")");
    fluent.add(fact.path("word").asText());
    fact.path("arguments").forEach(argument -> fluent.add(argument.asText()));
    return Optional.of(fluent.toString());
  }

  private static void numbers(JsonNode facts, long at, Map<String, Sample> samples) {
    for (JsonNode fact : facts) {
      series(fact)
          .ifPresent(name -> samples.put(name, Sample.of(at, fact.path("value").asDouble())));
    }
  }

  private static void goals(PastState state, long at, Map<String, Sample> samples) {
    Map<String, Integer> byState = new HashMap<>();
    state
        .goals()
        .all()
        .forEach(goal -> byState.merge(goal.path("state").asText(), 1, Integer::sum));
    GOALS.forEach(
        (name, states) ->
            samples.put(
                name,
                Sample.of(
                    at, states.stream().mapToInt(its -> byState.getOrDefault(its, 0)).sum())));
  }

  /** The lowest, the mean and the highest of it; null where nothing was measured. */
  private static Sample figure(Map.Entry<String, JsonNode> figure, long at) {
    JsonNode value = figure.getValue();
    return value.isNull()
        ? Sample.unknown(at)
        : new Sample(
            at, value.path(0).asDouble(), value.path(1).asDouble(), value.path(2).asDouble());
  }
}
