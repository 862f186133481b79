package org.maestro.platform.wires;

import jade.core.ProfileImpl;
import jade.util.leap.Properties;

/** How a container is to be made, and the connections that it shares with others of its process. */
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
