package org.maestro.hal;

/** A device's battery; it tells what was worth telling last. Clock thread only. */
public interface Battery {

  /** What is left, 0 to 1. */
  double charge();

  /** How long it takes from now on at a charging station; seconds. */
  double secondsToFull();

  /** Charges where the device stands until it is full; fails where there is no station. */
  void fill(Completion completion);

  /** Charges no further; the completion of the filling is not told. */
  void stopFilling();
}
