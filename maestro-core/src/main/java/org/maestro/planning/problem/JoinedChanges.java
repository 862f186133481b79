package org.maestro.planning.problem;

import java.util.AbstractList;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;

/**
 * The changes of an operator in parts, some of which it has in common with many: whoever picks a
 * cup up takes it out of every camera's view. What looks at all operators looks at such a part
 * once. Immutable.
 */
final class JoinedChanges extends AbstractList<Change> {
  private final List<List<Change>> parts;
  private final int size;

  private JoinedChanges(List<List<Change>> parts) {
    this.parts = List.copyOf(parts);
    this.size = parts.stream().mapToInt(List::size).sum();
  }

  /** The parts stay the very same objects. */
  static List<Change> of(List<List<Change>> parts) {
    List<List<Change>> filled = new ArrayList<>(parts);
    filled.removeIf(List::isEmpty);
    return filled.size() == 1 ? filled.get(0) : new JoinedChanges(filled);
  }

  /** The parts of such a list; of any other list that itself. */
  static List<List<Change>> parts(List<Change> changes) {
    return changes instanceof JoinedChanges joined ? joined.parts : List.of(changes);
  }

  @Override
  public Change get(int index) {
    Objects.checkIndex(index, size);
    int left = index;
    for (List<Change> part : parts) {
      if (left < part.size()) {
        return part.get(left);
      }
      left -= part.size();
    }
    throw new IndexOutOfBoundsException(index);
  }

  @Override
  public Iterator<Change> iterator() {
    return parts.stream().flatMap(List::stream).iterator();
  }

  @Override
  public int size() {
    return size;
  }
}
