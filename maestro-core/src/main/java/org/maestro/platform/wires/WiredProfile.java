package org.maestro.platform.wires;

import jade.core.ProfileImpl;
import jade.util.leap.Properties;

/**
 * The JADE profile of a container, with the connections that it shares with others of its process.
 */
public final class WiredProfile extends ProfileImpl {
  private final Wires wires;

  public WiredProfile(Properties properties, Wires wires) {
    super(properties);
    this.wires = wires;
  }

  Wires wires() {
    return wires;
  }
}
