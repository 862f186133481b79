package org.maestro.hal;

/**
 * A microphone with the recogniser of speech behind it, wherever that runs (ADE, 4; A51). It may be
 * a process of its own: all that it tells is a {@link Hypothesis}.
 */
public interface Ear {

  /**
   * Hears from now on.
   *
   * @return ends it
   */
  Runnable listen(Listener listener);

  /** Told on the clock's thread. */
  interface Listener {
    /** More was heard, or heard otherwise; also the same once more, for who has missed it. */
    void heard(Hypothesis hypothesis);

    /** It hears nothing any more. */
    void failed(String reason);
  }
}
