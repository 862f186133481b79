package org.maestro.platform.wires;

import jade.imtp.leap.JICP.JICPConnection;
import jade.mtp.TransportAddress;
import java.io.IOException;

/**
 * A connection that does not wait for ever for a host to answer, and knows whether it is closed.
 */
final class CuttableConnection extends JICPConnection {
  private static final int CONNECT_MILLIS = 2_000;

  CuttableConnection(TransportAddress address) throws IOException {
    super(address, CONNECT_MILLIS);
  }

  boolean isClosed() {
    return sc == null || sc.isClosed();
  }
}
