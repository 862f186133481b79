package org.maestro.rats.transport;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import javax.net.SocketFactory;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Makes sockets that send at once (with Nagle's algorithm a call takes 40 to 90 ms) and can be cut without goodbye.
 */
final class NoDelaySocketFactory extends SocketFactory {

  private static final Logger LOG = LoggerFactory.getLogger(NoDelaySocketFactory.class);

  private final List<Socket> sockets = new ArrayList<>();

  synchronized void cut() {
    for (Socket socket : sockets) {
      try {
        socket.close();
      } catch (IOException alreadyBroken) {
        LOG.debug("A socket was broken before it was cut", alreadyBroken);
      }
    }
    sockets.clear();
  }

  private synchronized Socket prepared(Socket socket) throws IOException {
    socket.setTcpNoDelay(true);
    sockets.add(socket);
    return socket;
  }

  @Override
  public Socket createSocket() throws IOException {
    return prepared(new Socket());
  }

  @Override
  public Socket createSocket(String host, int port) throws IOException {
    return prepared(new Socket(host, port));
  }

  @Override
  public Socket createSocket(String host, int port, InetAddress localHost, int localPort)
      throws IOException {
    return prepared(new Socket(host, port, localHost, localPort));
  }

  @Override
  public Socket createSocket(InetAddress host, int port) throws IOException {
    return prepared(new Socket(host, port));
  }

  @Override
  public Socket createSocket(InetAddress address, int port, InetAddress local, int localPort)
      throws IOException {
    return prepared(new Socket(address, port, local, localPort));
  }
}
