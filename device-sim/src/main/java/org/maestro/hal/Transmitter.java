package org.maestro.hal;

/** A radio that sends data where the signal is strong enough (ADE, 4; A48). */
public interface Transmitter {

  /** The least strength of the signal with which it sends; 0 to 100. */
  double neededStrength();

  /** How long it sends; seconds. */
  double seconds();

  void transmit(Listener listener);

  /** Told once per transmission, unless the device dies. */
  interface Listener {
    void sent();

    /**
     * Nothing was sent.
     *
     * @param strength of the signal here
     */
    void tooWeak(double strength);

    void failed(String reason);
  }
}
