package org.maestro.hal;

/** A sensor of the light at its place (Three-layered architecture, 4.1; M83). */
public interface IlluminationSensor {

  void read(Listener listener);

  /** Told once per reading, unless the sensor dies. */
  interface Listener {
    /**
     * @param lux within the sensor's range
     */
    void measured(double lux);

    void failed(String reason);
  }
}
