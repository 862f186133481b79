package org.maestro.coordination.api;

import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Work that takes longer than a behaviour may: done elsewhere, its result handed back on the
 * coordinator's thread.
 */
public interface Thinking {
  <T> void think(Supplier<T> work, Consumer<T> then);

  /**
   * For work that can wait a moment for such as cannot, that of goals of which nobody has heard
   * anything yet: a plan made again, or an explanation.
   */
  default Thinking patient() {
    return this;
  }
}
