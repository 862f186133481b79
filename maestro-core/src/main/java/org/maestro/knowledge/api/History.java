package org.maestro.knowledge.api;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * The statements on every state variable: who said what, when and how surely; statements that lost
 * are among them. The last statement of each variable is kept. Those before it go when they are
 * older than the kept time, and the oldest of them when there are too many of one variable, or too
 * many bytes of all. Not thread-safe.
 */
public final class History {
  private static final int BYTES_OF_A_CHARACTER = 2;

  private final Duration kept;
  private final int mostOfEach;
  private final long mostBytes;
  private final long bytesOfEach;
  private final Map<StateVariable, Deque<Note>> pasts = new LinkedHashMap<>();

  /** Those after which another came, by their serial numbers. */
  private final SortedMap<Long, Note> followed = new TreeMap<>();

  private long bytes;

  /**
   * A statement.
   *
   * @param believed false when it lost against another
   */
  public record Note(StateVariable variable, Belief belief, boolean believed, long serial) {}

  /**
   * @param bytesOfEach of memory that a statement takes here and in the dataset, beside its text
   */
  public History(KnowledgeSettings settings, long bytesOfEach) {
    this.kept = settings.kept();
    this.mostOfEach = settings.mostOfEach();
    this.mostBytes = settings.mostBytes();
    this.bytesOfEach = bytesOfEach;
  }

  /** Returns what is forgotten instead. */
  public List<Note> add(Note note, Instant now) {
    List<Note> forgotten = new ArrayList<>();
    Deque<Note> past = pasts.computeIfAbsent(note.variable(), key -> new ArrayDeque<>());
    if (!past.isEmpty()) {
      followed.put(past.getLast().serial(), past.getLast());
      bytes += bytes(past.getLast());
    }
    past.addLast(note);
    while (past.size() > mostOfEach || past.size() > 1 && isTooOld(past.getFirst(), now)) {
      forgotten.add(forget(past.getFirst()));
    }
    while (!followed.isEmpty() && (bytes > mostBytes || isTooOld(oldestFollowed(), now))) {
      forgotten.add(forget(oldestFollowed()));
    }
    return forgotten;
  }

  private Note oldestFollowed() {
    return followed.values().iterator().next();
  }

  /** The first of its variable. */
  private Note forget(Note old) {
    followed.remove(old.serial());
    Objects.requireNonNull(pasts.get(old.variable())).removeFirst();
    bytes -= bytes(old);
    return old;
  }

  private long bytes(Note note) {
    return bytesOfEach + (long) BYTES_OF_A_CHARACTER * note.belief().fact().length();
  }

  private boolean isTooOld(Note note, Instant now) {
    return note.belief().since().plus(kept).isBefore(now);
  }

  /** Oldest first. */
  public List<Belief> of(StateVariable variable) {
    return pasts.getOrDefault(variable, new ArrayDeque<>()).stream().map(Note::belief).toList();
  }
}
