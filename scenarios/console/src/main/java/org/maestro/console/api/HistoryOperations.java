package org.maestro.console.api;

import static org.maestro.console.api.Operation.get;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import java.util.function.Supplier;
import org.maestro.console.api.Operation.Parameter;
import org.maestro.console.api.Operation.Request;
import org.maestro.console.history.History;
import org.maestro.console.questions.RefusalException;

/** The operations that tell of the past. */
public final class HistoryOperations {
  private static final Instant EARLIEST = Instant.EPOCH;
  private static final Instant LATEST = Instant.parse("9999-12-31T23:59:59Z");
  private static final int USUAL_POINTS = 300;
  private static final int MOST_POINTS = 2_000;
  private static final int MOST_SERIES = 100;
  private static final Parameter FROM =
      Parameter.query("from", "An instant, such as 2026-01-31T12:00:00Z.");
  private static final Parameter TO = Parameter.query("to", "A later instant.");

  private final History history;
  private final Function<Supplier<JsonNode>, CompletableFuture<JsonNode>> aside;

  /**
   * @param aside does work that takes a while beside those who wait for it
   */
  public HistoryOperations(
      History history, Function<Supplier<JsonNode>, CompletableFuture<JsonNode>> aside) {
    this.history = history;
    this.aside = aside;
  }

  public List<Operation> operations() {
    return List.of(
        get(
            "/history",
            "past",
            "How far the recorded past goes back, and of which series there are samples.",
            "past",
            request -> aside.apply(history::kept)),
        get(
                "/history/state",
                "pastState",
                "What was so at a time: the home, facts, goals and agents as they were told then.",
                "past-state",
                request -> aside.apply(() -> state(instant(request, "at"))))
            .with(Parameter.query("at", "An instant, such as 2026-01-31T12:00:00Z.")),
        get(
                "/history/events",
                "pastEvents",
                "What became of goals and members in a span of time, oldest first.",
                "past-events",
                request -> aside.apply(() -> events(request)))
            .with(FROM, TO),
        get(
                "/history/samples",
                "pastSamples",
                "What numbers were in a span of time: of each part of it the lowest, the mean and"
                    + " the highest, and null where nothing was known.",
                "past-samples",
                request -> aside.apply(() -> samples(request)))
            .with(
                Parameter.query("series", "Names as GET /history lists them, with commas between."),
                FROM,
                TO,
                Parameter.number("points", "How many parts, 1 to 2000; usually 300.")));
  }

  private JsonNode state(Instant at) {
    return history
        .state(at)
        .orElseThrow(
            () ->
                RefusalException.badInput(
                    "Nothing is remembered of "
                        + at
                        + "; GET /history tells how far the past goes back."));
  }

  private JsonNode events(Request request) {
    Instant from = instant(request, "from");
    return history.events(from, after(from, request));
  }

  private JsonNode samples(Request request) {
    Instant from = instant(request, "from");
    List<String> series = List.of(request.parameter("series").split(","));
    if (series.size() > MOST_SERIES) {
      throw RefusalException.badInput("Ask for %d series at most.".formatted(MOST_SERIES));
    }
    int points = request.perhaps("points").map(Integer::parseInt).orElse(USUAL_POINTS);
    if (points < 1 || points > MOST_POINTS) {
      throw RefusalException.badInput(
          "points is from 1 to %d, not %d.".formatted(MOST_POINTS, points));
    }
    return history.samples(series, from, after(from, request), points);
  }

  private static Instant after(Instant from, Request request) {
    Instant to = instant(request, "to");
    if (!to.isAfter(from)) {
      throw RefusalException.badInput("to has to be later than from, %s.".formatted(from));
    }
    return to;
  }

  private static Instant instant(Request request, String name) {
    String text = request.parameter(name);
    try {
      Instant instant = Instant.parse(text);
      if (!instant.isBefore(EARLIEST) && !instant.isAfter(LATEST)) {
        return instant;
      }
    } catch (DateTimeException e) {
      throw noInstant(name, text);
    }
    throw noInstant(name, text);
  }

  private static RefusalException noInstant(String name, String text) {
    return RefusalException.badInput(
        "%s is an instant such as 2026-01-31T12:00:00Z, not \"%s\".".formatted(name, text));
  }
}
