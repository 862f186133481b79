package org.maestro.assembly;

import java.util.ArrayDeque;
import java.util.Deque;

/** The parts that a site has opened, to be closed with it: the latest first. For one thread. */
final class OpenParts implements AutoCloseable {
  private final Deque<AutoCloseable> parts = new ArrayDeque<>();

  /** Returns the part, which is closed with the others from now on. */
  <T extends AutoCloseable> T opened(T part) {
    parts.addFirst(part);
    return part;
  }

  /**
   * One part that cannot be closed does not keep the others open.
   *
   * @throws SiteException that tells of the first part that could not be closed; the others' are
   *     suppressed
   */
  @Override
  public void close() {
    SiteException failure = null;
    while (!parts.isEmpty()) {
      try {
        parts.removeFirst().close();
      } catch (Exception e) {
        if (failure == null) {
          failure = new SiteException("The site could not be closed: " + e.getMessage(), e);
        } else {
          failure.addSuppressed(e);
        }
      }
    }
    if (failure != null) {
      throw failure;
    }
  }
}
