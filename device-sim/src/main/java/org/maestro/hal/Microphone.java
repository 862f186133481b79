package org.maestro.hal;

import java.util.OptionalDouble;

/** The sound of a room, as it is (ADE, 3.3; A44); what is said in it is an {@link Ear}'s. */
public interface Microphone {

  /**
   * Records from now on, in stretches of a tenth of a second or so that follow each other without a
   * gap.
   *
   * @param testTone hertz of a tone that is mixed in, so that the way of the sound can be tried
   *     without anybody's making any
   * @return ends it
   */
  Runnable record(OptionalDouble testTone, Listener listener);

  /** Samples a second. */
  int rate();

  /** Told on the clock's thread. */
  interface Listener {
    /** A stretch that ends now. */
    void recorded(Sound sound);

    /** It records nothing any more. */
    void failed(String reason);
  }
}
