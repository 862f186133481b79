package org.maestro.console.history;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
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
import org.maestro.storage.StorageFault;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The entries of the past, up to a weight and an age: in memory, to be asked by any thread, and in
 * files where there are some. What a disk does not take is kept in memory all the same; that is
 * told once, and when it is over. One thread adds.
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
  private final Optional<HistoryFiles> files;

  // These are the adding thread's own.
  private final PastState state = new PastState();
  private final Set<String> known = new HashSet<>();
  private double speed;

  // Guarded by this.
  private final Deque<Segment> segments = new ArrayDeque<>();
  private long weight;
  private Optional<String> problem = Optional.empty();

  Archive(Limits limits, Optional<HistoryFiles> files) {
    this.limits = limits;
    this.files = files;
  }

  /** What is so now. */
  PastState state() {
    return state;
  }

  /** Reads what was recorded before; what is damaged is left out. */
  void read() {
    if (files.isEmpty()) {
      return;
    }
    int[] damaged = {0};
    try {
      files
          .get()
          .read(
              line ->
                  Entry.read(line)
                      .ifPresentOrElse(entry -> remember(entry, line), () -> damaged[0]++));
    } catch (IOException e) {
      isAmiss("The recorded past cannot be read: " + StorageFault.words(e) + ".");
    }
    if (damaged[0] > 0) {
      LOG.warn("{} lines of the recorded past are damaged and left out.", damaged[0]);
    }
  }

  /** A platform begins to be recorded; nothing is known of it yet. */
  void begin(Instant at, double clock, double itsSpeed) {
    speed = itsSpeed;
    ObjectNode nothing = new PastState().document(clock);
    begin(new Entry(at, clock, Entry.Kind.STATE, nothing.put(SPEED, speed).put(FIRST, true)));
  }

  private void begin(Entry all) {
    String line = all.line();
    remember(all, line);
    keep(files -> files.begin(line, all.at()));
  }

  void add(Entry entry) {
    String line = entry.line();
    remember(entry, line);
    if (isAmiss()) {
      if (entry.kind() == Entry.Kind.FIGURES) {
        keep(files -> files.begin(afterGap(entry).line(), entry.at()));
      }
    } else {
      keep(files -> files.add(line));
    }
    if (isFull()) {
      begin(all(entry));
    }
  }

  private Entry all(Entry latest) {
    return state(latest, state.document(latest.clock()));
  }

  /** Lines are missing: who reads this later knows nothing of the time before it. */
  private Entry afterGap(Entry latest) {
    return state(latest, state.document(latest.clock()).put(FIRST, true));
  }

  private Entry state(Entry latest, ObjectNode document) {
    return new Entry(latest.at(), latest.clock(), Entry.Kind.STATE, document.put(SPEED, speed));
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

  private interface Keeping {
    void in(HistoryFiles files) throws IOException;
  }

  private void keep(Keeping keeping) {
    if (files.isPresent()) {
      try {
        keeping.in(files.get());
        isWell();
      } catch (IOException e) {
        isAmiss("The past is not kept on the disk now: " + StorageFault.words(e) + ".");
      }
    }
  }

  private synchronized void isAmiss(String sentence) {
    if (problem.isEmpty()) {
      LOG.warn("{} The platform goes on, and so does what it remembers in memory.", sentence);
    }
    problem = Optional.of(sentence);
  }

  private synchronized void isWell() {
    if (problem.isPresent()) {
      LOG.warn("The past is kept on the disk again.");
      problem = Optional.empty();
    }
  }

  private synchronized boolean isAmiss() {
    return problem.isPresent();
  }

  /** Why nothing is kept on the disk now, a sentence. */
  synchronized Optional<String> problem() {
    return problem;
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
    keep(HistoryFiles::close);
  }
}
