package org.maestro.console.history;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The entries of the past, up to a weight and an age: in memory, to be asked by any thread, and in
 * files where there are some. One thread adds.
 */
final class Archive implements AutoCloseable {
  /** Of the platform's clock, in entries of all that is so. */
  static final String SPEED = "speed";

  /** Figures are recorded more often than that as long as anything is. */
  static final Duration LONGEST_SILENCE = Duration.ofSeconds(30);

  private static final Logger LOG = LoggerFactory.getLogger(Archive.class);
  private static final String FIRST = "first";
  private static final int CHANGES_TO_ONE_STATE = 4;

  /** The limits of what is kept, in memory and again in files. */
  record Limits(long mostBytes, Duration longest, long segmentBytes) {}

  private final Limits limits;
  private final DiskCopy disk;

  // These are the adding thread's own.
  private final PastState state = new PastState();
  private final Set<String> known = new HashSet<>();
  private double speed;

  // Guarded by this.
  private final Deque<Segment> segments = new ArrayDeque<>();
  private long weight;

  Archive(Limits limits, DiskCopy disk) {
    this.limits = limits;
    this.disk = disk;
  }

  /** What is so now. */
  PastState state() {
    return state;
  }

  /** Reads what was recorded before; what is damaged is left out. */
  void read() {
    int[] damaged = {0};
    disk.read(
        line ->
            Entry.read(line).ifPresentOrElse(entry -> remember(entry, line), () -> damaged[0]++));
    if (damaged[0] > 0) {
      LOG.warn("{} lines of the recorded past are damaged and left out.", damaged[0]);
    }
  }

  /** A platform begins to be recorded; nothing is known of it yet. */
  void begin(Instant at, double clock, double itsSpeed) {
    speed = itsSpeed;
    Entry nothing = state(at, clock, new PastState().document(clock).put(FIRST, true));
    remember(nothing, nothing.line());
    disk.begin(nothing);
  }

  void add(Entry entry) {
    String line = entry.line();
    remember(entry, line);
    if (disk.problem().isEmpty()) {
      disk.add(line);
    } else if (entry.kind() == Entry.Kind.FIGURES) {
      disk.begin(afterGap(entry));
    }
    if (isFull()) {
      Entry all = all(entry);
      remember(all, all.line());
      disk.begin(disk.problem().isEmpty() ? all : afterGap(entry));
    }
  }

  private Entry all(Entry latest) {
    return state(latest.at(), latest.clock(), state.document(latest.clock()));
  }

  /** Lines are missing: who reads this later knows nothing of the time before it. */
  private Entry afterGap(Entry latest) {
    return state(latest.at(), latest.clock(), state.document(latest.clock()).put(FIRST, true));
  }

  private Entry state(Instant at, double clock, ObjectNode document) {
    return new Entry(at, clock, Entry.Kind.STATE, document.put(SPEED, speed));
  }

  private synchronized boolean isFull() {
    return segments.getLast().added()
        > Math.max(limits.segmentBytes(), CHANGES_TO_ONE_STATE * segments.getLast().first());
  }

  private synchronized void remember(Entry entry, String line) {
    boolean isFirst = entry.told().path(FIRST).asBoolean();
    if (entry.kind() == Entry.Kind.STATE) {
      Optional<Instant> before = Optional.ofNullable(segments.peekLast()).map(Segment::end);
      segments.addLast(new Segment());
      before.filter(at -> isFirst).ifPresent(this::nothingIsKnownFrom);
    } else if (segments.isEmpty()) {
      return;
    }
    Segment last = segments.getLast();
    weight -= last.weight();
    Map<String, Sample> samples = Samples.taken(entry, state);
    last.add(entry, line, samples);
    weight += last.weight();
    samples.forEach(
        (series, sample) -> {
          if (sample.isKnown()) {
            known.add(series);
          } else {
            known.remove(series);
          }
        });
    forgetOld(entry.at());
  }

  /** While nobody records, nobody knows. */
  private void nothingIsKnownFrom(Instant at) {
    known.forEach(series -> segments.getLast().add(series, Sample.unknown(at.toEpochMilli())));
    known.clear();
    weight += segments.getLast().weight();
  }

  private void forgetOld(Instant now) {
    while (segments.size() > 1
        && (weight > limits.mostBytes()
            || segments.getFirst().end().isBefore(now.minus(limits.longest())))) {
      weight -= segments.removeFirst().weight();
    }
  }

  /** Why nothing is kept on the disk now, a sentence. */
  Optional<String> problem() {
    return disk.problem();
  }

  /** From when to when something is remembered; empty before there is anything. */
  synchronized Optional<Span> span() {
    return segments.isEmpty()
        ? Optional.empty()
        : Optional.of(new Span(segments.getFirst().begin(), segments.getLast().end()));
  }

  /** The names of all series of which there are samples. */
  synchronized Set<String> series() {
    Set<String> names = new TreeSet<>();
    segments.forEach(segment -> names.addAll(segment.series()));
    return names;
  }

  /** What was recorded up to a moment; empty before there is anything. */
  synchronized Optional<Past> until(Instant at) {
    Optional<Segment> last = Optional.empty();
    for (Segment segment : segments) {
      if (!segment.begin().isAfter(at)) {
        last = Optional.of(segment);
      }
    }
    return last.map(segment -> segment.until(at));
  }

  synchronized List<Segment.Happening> happenings(Instant from, Instant to) {
    return segments.stream().flatMap(segment -> segment.happenings(from, to).stream()).toList();
  }

  /** All samples that are remembered of each of these, oldest first. */
  synchronized Map<String, List<Sample>> samples(List<String> series) {
    Map<String, List<Sample>> found = new HashMap<>();
    for (String name : series) {
      List<Sample> all = found.computeIfAbsent(name, its -> new ArrayList<>());
      segments.forEach(segment -> all.addAll(segment.samples(name)));
    }
    return found;
  }

  synchronized long weight() {
    return weight;
  }

  @Override
  public void close() {
    disk.close();
  }
}
