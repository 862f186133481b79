package org.maestro.rats.member;

import java.time.Duration;
import java.util.Map;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.StreamFrame;

/**
 * One running call as its procedure sees it. The first final report counts, later ones do nothing.
 * Clock thread only.
 */
public interface Execution {

  Call call();

  /** A continuous feature runs and these are its first values. */
  void established(Map<String, Object> values);

  /** A value set of a continuous feature's stream. */
  void observed(Map<String, Object> values);

  /**
   * A frame of what a continuous feature streams, once it is established (ADE, 3.3; A44). Streams
   * are for whoever listens now: while the bus is slower than the device, pictures that have not
   * left are given up for newer ones, and the oldest of more than twenty stretches of sound; the
   * receiver sees the gap by the frames' numbers. One that is longer than {@link
   * StreamFrame#MOST_BYTES} is given up, too.
   *
   * @param capturedAt when it was taken, by the clock; not after now
   * @param mediaType such as {@code image/png}
   * @param data must not be changed afterwards
   */
  void streamed(Duration capturedAt, String mediaType, byte[] data);

  void progress(double fraction);

  void succeed(Map<String, Object> values);

  void fail(RatsError error);

  /**
   * The member sees that it will not manage, and gives the task back before its timeout
   * (Three-layered architecture, 3.2.1; M44): its caller is told why at once, the exit strategy
   * brings the device to a safe state, then the call fails.
   */
  void giveBack(RatsError reason);

  /**
   * Establishes a continuous feature with a first reading, and tells a further one as often as the
   * feature's {@link Frequency} and the call's wish have it, until the call ends (Three-layered
   * architecture, 3.2.2; M52).
   */
  void observeRegularly(Reading reading);

  /**
   * What to do on cancel or timeout: bring the device to a safe state (Three-layered architecture,
   * 3.2.1; M45), then run the given completion. Without it a cancel completes at once.
   */
  void onCancel(ExitStrategy strategy);

  boolean ended();

  /** Values of a sensor now. */
  interface Reading {
    Map<String, Object> values();
  }

  interface ExitStrategy {
    void exit(Runnable safe);
  }
}
