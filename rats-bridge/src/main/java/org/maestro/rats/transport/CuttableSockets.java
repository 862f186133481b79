package org.maestro.rats.transport;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.net.SocketFactory;
import javax.net.ssl.SSLContext;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Makes the sockets of one connection, and can cut them without goodbye. */
final class CuttableSockets extends SocketFactory {

  private static final Logger LOG = LoggerFactory.getLogger(CuttableSockets.class);

  private final Optional<SSLContext> tls;
  private final List<Socket> sockets = new ArrayList<>();
  private boolean cut;

  /**
   * @param tls empty: plain sockets
   */
  CuttableSockets(Optional<SSLContext> tls) {
    this.tls = tls;
  }

  /** Closes all, and makes no more. */
  synchronized void cut() {
    cut = true;
    for (Socket socket : sockets) {
      try {
        socket.close();
      } catch (IOException alreadyBroken) {
        LOG.debug("A socket was broken before it was cut", alreadyBroken);
      }
    }
    sockets.clear();
  }

  @Override
  public synchronized Socket createSocket() throws IOException {
    if (cut) {
      throw new IOException("the connection is not wanted any more");
    }
    Socket socket = tls.isPresent() ? new TlsSocket(tls.get()) : new PatientSocket();
    sockets.add(socket);
    return socket;
  }

  @Override
  public Socket createSocket(String host, int port) throws IOException {
    return connected(new InetSocketAddress(host, port));
  }

  @Override
  public Socket createSocket(String host, int port, InetAddress local, int localPort)
      throws IOException {
    return connected(new InetSocketAddress(host, port), new InetSocketAddress(local, localPort));
  }

  @Override
  public Socket createSocket(InetAddress host, int port) throws IOException {
    return connected(new InetSocketAddress(host, port));
  }

  @Override
  public Socket createSocket(InetAddress host, int port, InetAddress local, int localPort)
      throws IOException {
    return connected(new InetSocketAddress(host, port), new InetSocketAddress(local, localPort));
  }

  private Socket connected(SocketAddress remote) throws IOException {
    Socket socket = createSocket();
    socket.connect(remote);
    return socket;
  }

  private Socket connected(SocketAddress remote, SocketAddress local) throws IOException {
    Socket socket = createSocket();
    socket.bind(local);
    socket.connect(remote);
    return socket;
  }
}
