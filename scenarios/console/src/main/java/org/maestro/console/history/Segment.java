package org.maestro.console.history;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * A stretch of the past, that begins with all that was so: it can be understood without what was
 * before it, which is forgotten as a whole. Not thread-safe.
 */
final class Segment {
  /** What an object costs beside its text, about. */
  private static final int OVERHEAD = 64;

  private final List<Line> lines = new ArrayList<>();
  private final Map<String, List<Sample>> samples = new HashMap<>();
  private final List<Happening> happenings = new ArrayList<>();
  private long weight;

  /** An entry as it is kept: parsed again when somebody asks for it. */
  private record Line(Instant at, double clock, String text) {}

  /** What became of a goal or of a member, and when. */
  record Happening(Instant at, double clock, JsonNode told) {}

  void add(Entry entry, String line, Map<String, Sample> its) {
    lines.add(new Line(entry.at(), entry.clock(), line));
    weight += line.length() + OVERHEAD;
    its.forEach((series, sample) -> add(series, sample));
    if (entry.kind() == Entry.Kind.HAPPENING) {
      happenings.add(new Happening(entry.at(), entry.clock(), entry.told()));
      weight += line.length() + OVERHEAD;
    }
  }

  void add(String series, Sample sample) {
    samples.computeIfAbsent(series, name -> new ArrayList<>()).add(sample);
    weight += OVERHEAD;
  }

  /** In bytes, about. */
  long weight() {
    return weight;
  }

  /** The length of its first entry. */
  long first() {
    return lines.get(0).text().length();
  }

  /** How much of its weight came after that. */
  long added() {
    return weight - first();
  }

  Instant begin() {
    return lines.get(0).at();
  }

  Instant end() {
    return lines.get(lines.size() - 1).at();
  }

  List<Sample> samples(String series) {
    return List.copyOf(samples.getOrDefault(series, List.of()));
  }

  Set<String> series() {
    return Set.copyOf(samples.keySet());
  }

  List<Happening> happenings(Instant from, Instant to) {
    return happenings.stream()
        .filter(one -> !one.at().isBefore(from) && !one.at().isAfter(to))
        .toList();
  }

  /** What was recorded up to a moment, which is not before its begin. */
  Past until(Instant at) {
    int end = lines.size();
    while (end > 1 && lines.get(end - 1).at().isAfter(at)) {
      end--;
    }
    Line last = lines.get(end - 1);
    return new Past(
        lines.subList(0, end).stream().map(Line::text).toList(),
        last.at(),
        last.clock(),
        end < lines.size() ? lines.get(end).clock() : Double.POSITIVE_INFINITY);
  }
}
