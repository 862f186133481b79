package org.maestro.rats.transport;

import java.time.Duration;
import java.util.List;

/**
 * Loss, repetition, change and delay of messages on a bad bus within the process. Told where they
 * are published, or heard.
 */
public interface Disturbance {

  /** A bus that does what it should. */
  Disturbance NONE = new Disturbance() {};

  /**
   * One delivery of a message on a bad bus.
   *
   * @param later than usual, in simulated time
   */
  record Copy(Publication publication, Duration later) {}

  /** None: it is lost, and nobody tells its publisher. */
  default List<Copy> published(String client, Publication publication) {
    return List.of(new Copy(publication, Duration.ZERO));
  }

  /** How much later than usual the client hears what reaches it now; in the same order. */
  default Duration heardLater(String client) {
    return Duration.ZERO;
  }
}
