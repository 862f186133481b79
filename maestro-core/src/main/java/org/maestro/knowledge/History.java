package org.maestro.knowledge;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Who said what of every state variable, when and how surely; statements that lost are among them.
 * What is older than the kept time goes, but for the last statement of each variable. Not
 * thread-safe.
 */
final class History {

  private final Duration kept;
  private final int mostOfEach;
  private final Map<StateVariable, Deque<Note>> pasts = new LinkedHashMap<>();
  private final Map<Long, Note> inOrder = new LinkedHashMap<>();

  /**
   * A statement.
   *
   * @param believed false when it lost against another
   */
  record Note(StateVariable variable, Belief belief, boolean believed, long serial) {}

  History(Duration kept, int mostOfEach) {
    this.kept = kept;
    this.mostOfEach = mostOfEach;
  }

  /** Returns what is forgotten instead. */
  List<Note> add(Note note, Instant now) {
    List<Note> forgotten = new ArrayList<>();
    Deque<Note> past = pasts.computeIfAbsent(note.variable(), key -> new ArrayDeque<>());
    past.addLast(note);
    inOrder.put(note.serial(), note);
    while (past.size() > mostOfEach || past.size() > 1 && isTooOld(past.getFirst(), now)) {
      inOrder.remove(past.getFirst().serial());
      forgotten.add(past.removeFirst());
    }
    Iterator<Note> oldest = inOrder.values().iterator();
    while (oldest.hasNext()) {
      Note old = oldest.next();
      if (!isTooOld(old, now)) {
        break;
      }
      oldest.remove();
      Deque<Note> its = pasts.get(old.variable());
      if (its.size() > 1 && its.getFirst().equals(old)) {
        forgotten.add(its.removeFirst());
      }
    }
    return forgotten;
  }

  private boolean isTooOld(Note note, Instant now) {
    return note.belief().since().plus(kept).isBefore(now);
  }

  /** Oldest first. */
  List<Belief> of(StateVariable variable) {
    return pasts.getOrDefault(variable, new ArrayDeque<>()).stream().map(Note::belief).toList();
  }
}
