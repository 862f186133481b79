package org.maestro.rats.protocol;

import java.time.Instant;

/**
 * One picture, or a stretch of sound, of a stream that a call has begun (ADE, 3.3; A44). It stands
 * for itself: whoever has missed others can show it. The data must not be changed: it may be
 * shared.
 *
 * @param id the call's
 * @param from the member that streams
 * @param number counts the frames of the call from 1 on, those too that were given up on the way:
 *     who misses one sees a gap
 * @param capturedAt when the picture was taken, or the sound began, by the member's clock
 * @param mediaType what the data is, such as {@code image/png}, or sound of 16 bits as {@code
 *     audio/L16;rate=16000;channels=1} (RFC 2586)
 * @param data at most {@link #MOST_BYTES} bytes
 */
public record StreamFrame(
    String id,
    String from,
    String feature,
    long number,
    Instant capturedAt,
    String mediaType,
    byte[] data) {

  /** So many fit into a message, written as text. */
  public static final int MOST_BYTES = 190_000;
}
