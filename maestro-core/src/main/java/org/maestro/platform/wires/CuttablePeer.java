package org.maestro.platform.wires;

import jade.core.Profile;
import jade.imtp.leap.ICP;
import jade.imtp.leap.ICPException;
import jade.imtp.leap.JICP.ConnectionFactory;
import jade.imtp.leap.JICP.JICPPeer;
import jade.mtp.TransportAddress;
import java.net.ServerSocket;

/**
 * JADE's own transport between containers, over connections that can be cut. JADE makes it by its
 * class name; it finds the {@link Wires} in the profile, which has to be a {@link WiredProfile}.
 */
public final class CuttablePeer extends JICPPeer {
  private Wires wires = new Wires();
  private String host = "";

  @Override
  public TransportAddress activate(ICP.Listener listener, String peer, Profile profile)
      throws ICPException {
    wires = Wires.of(profile);
    host = profile.getParameter(Profile.LOCAL_HOST, "");
    return super.activate(listener, peer, profile);
  }

  /** JADE by itself listens on all interfaces, or on loopback. */
  @Override
  protected ServerSocket getServerSocket(String any, int port, boolean changePortIfBusy)
      throws ICPException {
    return super.getServerSocket(host.isEmpty() ? any : host, port, changePortIfBusy);
  }

  @Override
  public ConnectionFactory getConnectionFactory() {
    return wires.factory(CuttableConnection::new);
  }
}
