package org.maestro.console;

import org.maestro.rats.security.Role;

/** What happens, for who listens. Any thread may call. */
interface EventSource {
  /**
   * Somebody listens from now on, or, when there are too many already, is let go.
   *
   * @param then told when all that is so is on its way
   */
  void listen(EventQueue listener, Runnable then);

  void leave(EventQueue listener);

  /** The role of who may listen on a secured site. */
  default Role needs() {
    return Role.VIEWER;
  }

  /**
   * The same for who wants to hear of one thing above all; most tell everybody the same.
   *
   * @param chosen its name; "" of none
   */
  default EventSource of(String chosen) {
    return this;
  }
}
