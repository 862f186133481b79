package org.maestro.console.history;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.function.Supplier;
import org.maestro.console.documents.JsonMembers;

/**
 * The past of a platform as its pages were told it (M25): 32 MiB of it and a day at most, in memory
 * and once more in files where there is a directory. One thread tells it what happens; any thread
 * asks, and says how long something took.
 */
public final class History implements AutoCloseable {
  private static final Archive.Limits LIMITS =
      new Archive.Limits(32L << 20, Duration.ofDays(1), 256L << 10);

  private final Archive archive;
  private final Recorder recorder;
  private final InstantSource wall;
  private final Supplier<Duration> clock;
  private final double speed;

  /**
   * @param directory of files; empty: it ends with the process
   * @param clock simulated time since the platform's clock began
   * @param speed simulated seconds in one of wall time
   */
  public History(Optional<Path> directory, Supplier<Duration> clock, double speed) {
    this.archive =
        new Archive(
            LIMITS,
            new DiskCopy(
                directory.map(
                    path ->
                        new HistoryFiles(
                            path, LIMITS.mostBytes(), LIMITS.longest(), Disk.real()))));
    this.wall = InstantSource.system();
    this.clock = clock;
    this.speed = speed;
    this.recorder = new Recorder(archive, wall, clock, speed);
  }

  /** Reads what was recorded before, and begins. */
  public void begin() {
    recorder.begin();
  }

  /** One event of those that pages are told. */
  public void take(String event, JsonNode document) {
    recorder.take(event, document);
  }

  /** Some seconds have passed; what was measured in them is recorded. */
  public void measure() {
    recorder.measure();
  }

  /** Somebody has answered. */
  public void answered(Answerer answerer, Duration after) {
    recorder.answered(answerer, after);
  }

  /** How far it goes back, and what there is of it. */
  public JsonNode kept() {
    Optional<Span> span = archive.span();
    JsonMembers document =
        JsonMembers.empty()
            .text("from", span.map(its -> its.from().toString()))
            .text("to", span.map(its -> its.to().toString()))
            .text("now", wall.instant().toString())
            .number("clock_s", clock.get().toMillis() / 1000.0)
            .number("speed", speed)
            .text("problem", archive.problem())
            .words("series", archive.series());
    document
        .node()
        .put("bytes", archive.weight())
        .put("most_bytes", LIMITS.mostBytes())
        .put("most_s", LIMITS.longest().toSeconds());
    return document.node();
  }

  /** What was so at a moment; empty when that is not remembered. */
  public Optional<JsonNode> state(Instant at) {
    return archive.until(at).map(past -> past.document(at));
  }

  /** What became of goals and members from one moment to another, oldest first. */
  public JsonNode events(Instant from, Instant to) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode events = document.node().putArray("events");
    for (Segment.Happening happening : archive.happenings(from, to)) {
      ObjectNode row =
          JsonMembers.in(events)
              .text("at", happening.at().toString())
              .number("clock_s", happening.clock())
              .node();
      happening.told().properties().forEach(part -> row.set(part.getKey(), part.getValue()));
    }
    return document.node();
  }

  /**
   * What series were from one moment to another, in so many parts.
   *
   * @param to later than from
   */
  public JsonNode samples(List<String> series, Instant from, Instant to, int points) {
    long begin = from.toEpochMilli();
    long end = to.toEpochMilli();
    long until = archive.span().map(span -> until(span.to()).toEpochMilli()).orElse(begin);
    JsonMembers document =
        JsonMembers.empty().text("from", from.toString()).text("to", to.toString());
    ArrayNode at = document.node().putArray("at");
    for (int i = 0; i < points; i++) {
      at.add(
          Instant.ofEpochMilli(begin + Math.round(i * ((end - begin) / (double) points)))
              .toString());
    }
    ArrayNode rows = document.node().putArray("series");
    Map<String, List<Sample>> samples = archive.samples(series);
    for (String name : series) {
      JsonMembers row = JsonMembers.in(rows).text("name", name);
      Buckets buckets =
          Buckets.of(samples.getOrDefault(name, List.of()), begin, end, until, points);
      values(row.node().putArray("low"), buckets, buckets::low);
      values(row.node().putArray("mean"), buckets, buckets::mean);
      values(row.node().putArray("high"), buckets, buckets::high);
    }
    return document.node();
  }

  /** As long as figures come, what was told last is so still. */
  private Instant until(Instant last) {
    Instant now = wall.instant();
    return now.isBefore(last.plus(Archive.LONGEST_SILENCE)) ? now : last;
  }

  private static void values(ArrayNode array, Buckets buckets, IntToDoubleFunction value) {
    for (int i = 0; i < buckets.number(); i++) {
      if (buckets.isKnown(i)) {
        array.add(value.applyAsDouble(i));
      } else {
        array.addNull();
      }
    }
  }

  /** What was recorded is in the files by then. */
  @Override
  public void close() {
    archive.close();
  }
}
