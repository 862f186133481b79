package org.maestro.hal;

/**
 * A map of the strength of a signal, asked for where a robot is: a service beside the robot, which
 * has no receiver of its own (ADE, 4, figure 2; A47).
 */
public interface SignalField {

  /** How long a reading takes; seconds. */
  double seconds();

  void read(String robot, Listener listener);

  /** Told once per reading, unless the service dies. */
  interface Listener {
    /**
     * @param strength of the signal where the robot is now; 0 to 100
     */
    void measured(double strength);

    void failed(String reason);
  }
}
