package org.maestro.platform.guard;

import jade.core.Profile;
import jade.imtp.leap.ICP;
import jade.imtp.leap.ICPException;
import jade.imtp.leap.JICP.ConnectionFactory;
import jade.imtp.leap.JICP.JICPConnection;
import jade.imtp.leap.JICP.JICPPeer;
import jade.mtp.TransportAddress;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import org.maestro.platform.wires.Wires;
import org.maestro.rats.security.SecurityFilesException;

/**
 * JADE's own protocol between containers over guarded connections. JADE makes it by its class name.
 * Its own {@code JICPSPeer} asks nobody for a certificate, and listens on all interfaces.
 */
public final class GuardedPeer extends JICPPeer {
  private static final int BACKLOG = 50;

  // JADE makes a peer by its class name, and activates it before anything uses it.
  @SuppressWarnings("NullAway.Init")
  private Guard guard;

  private Wires wires = new Wires();

  @Override
  public TransportAddress activate(ICP.Listener listener, String peer, Profile profile)
      throws ICPException {
    try {
      guard = Guard.of(profile);
      wires = Wires.of(profile);
    } catch (SecurityFilesException unusable) {
      throw new ICPException(unusable.getMessage(), unusable);
    }
    return super.activate(listener, peer, profile);
  }

  @Override
  public ConnectionFactory getConnectionFactory() {
    return wires.factory(
        to -> new JICPConnection(guard.call(to.getHost(), Integer.parseInt(to.getPort()))));
  }

  @Override
  protected ServerSocket getServerSocket(String host, int port, boolean changePortIfBusy)
      throws ICPException {
    try {
      return new Gate(bound(host, port, changePortIfBusy), guard);
    } catch (IOException busy) {
      throw new ICPException("Cannot listen for other containers on port " + port, busy);
    }
  }

  /** JADE gives no host where all interfaces are meant. */
  private static ServerSocket bound(String host, int port, boolean changePortIfBusy)
      throws IOException {
    InetAddress address = host == null ? null : InetAddress.getByName(host);
    ServerSocket socket = new ServerSocket();
    try {
      socket.bind(new InetSocketAddress(address, port), BACKLOG);
      return socket;
    } catch (IOException busy) {
      socket.close();
      if (!changePortIfBusy) {
        throw busy;
      }
      ServerSocket another = new ServerSocket();
      another.bind(new InetSocketAddress(address, 0), BACKLOG);
      return another;
    }
  }
}
