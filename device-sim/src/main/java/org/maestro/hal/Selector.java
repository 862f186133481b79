package org.maestro.hal;

import java.util.Optional;

/** What of several is chosen at an appliance, such as the show on a television. */
public interface Selector {

  /**
   * @param choice its name in the home
   */
  void select(String choice, Completion completion);

  /** Empty while it is off, or nothing has been chosen yet. */
  Optional<String> selected();
}
