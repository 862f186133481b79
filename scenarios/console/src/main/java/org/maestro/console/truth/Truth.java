package org.maestro.console.truth;

import java.util.List;

/** The truth of a simulated home, as it is at the time. Any thread may ask. */
@FunctionalInterface
public interface Truth {
  /** All of which there is something to tell, by name. */
  List<TrueThing> now();
}
