package org.maestro.coordination.agenda;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import org.maestro.sl.Truth;

/**
 * What has become so, among conditions of which each is so or not. What is not known any more is
 * not so; but where that is because somebody who could tell is gone, it is only not so when that is
 * known. Not safe for use by several threads.
 *
 * @param <T> a condition
 */
final class Edges<T> {
  private final Set<T> known = new LinkedHashSet<>();
  private final Set<T> doubtful = new LinkedHashSet<>();

  /** These were so, as far as was known before. */
  void resume(Collection<T> former) {
    doubtful.addAll(former);
  }

  /** What counts as so, and so cannot become so. */
  Set<T> so() {
    Set<T> so = new LinkedHashSet<>(known);
    so.addAll(doubtful);
    return so;
  }

  /**
   * Looks again.
   *
   * @param holding all that is known to be so now
   * @param truth of one condition now
   * @return what has become so
   */
  List<T> look(Collection<T> holding, Function<T, Truth> truth) {
    List<T> become = new ArrayList<>(holding);
    become.removeAll(so());
    known.clear();
    known.addAll(holding);
    doubtful.removeIf(one -> known.contains(one) || truth.apply(one) != Truth.UNKNOWN);
    return become;
  }

  /** The same, just after somebody was lost: what is unknown since may be so still. */
  void lost(Function<T, Truth> truth) {
    List<T> unknown = known.stream().filter(one -> truth.apply(one) == Truth.UNKNOWN).toList();
    unknown.forEach(known::remove);
    doubtful.addAll(unknown);
  }

  /** It has not become so yet: it is to be found again. */
  void putOff(T one) {
    known.remove(one);
  }
}
