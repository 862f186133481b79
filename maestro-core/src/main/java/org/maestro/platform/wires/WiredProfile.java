package org.maestro.platform.wires;

import jade.core.ProfileImpl;
import jade.util.leap.Properties;

/** How a container is to be made, and the connections that it shares with others of its process. */
public final class WiredProfile extends ProfileImpl {
  private static final String PEERS = "icps";

  private final Wires wires;

  public WiredProfile(Properties properties, Wires wires) {
    super(with(properties));
    this.wires = wires;
  }

  private static Properties with(Properties properties) {
    if (properties.getProperty(PEERS) == null) {
      properties.setProperty(PEERS, CuttablePeer.class.getName());
    }
    return properties;
  }

  Wires wires() {
    return wires;
  }
}
