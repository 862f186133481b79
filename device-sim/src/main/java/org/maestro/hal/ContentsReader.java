package org.maestro.hal;

import java.util.Set;
import java.util.function.Consumer;

/** Reads what is in a container, such as by the tags of the things in a refrigerator. */
public interface ContentsReader {

  /**
   * Reads once, which takes a moment.
   *
   * @param read told the names of the things that are there
   * @param failed told why it cannot read
   */
  void read(Consumer<Set<String>> read, Consumer<String> failed);
}
