package org.maestro.hal;

/**
 * A stretch of sound of one channel.
 *
 * @param rate samples a second
 * @param samples from -32768 to 32767
 */
public record Sound(int rate, short[] samples) {
  private static final double NANOS = 1e9;

  public Sound {
    samples = samples.clone();
  }

  @Override
  public short[] samples() {
    return samples.clone();
  }

  public double seconds() {
    return (double) samples.length / rate;
  }

  /** How long it is; nanoseconds. */
  public long nanos() {
    return Math.round(seconds() * NANOS);
  }
}
