package org.maestro.platform.letters;

import jade.core.Profile;
import jade.mtp.InChannel;
import jade.mtp.MTPException;
import jade.mtp.TransportAddress;
import jade.mtp.http.MessageTransportProtocol;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * JADE's HTTP transport, which takes messages of any size, behind a doorway that takes none above
 * {@link Doorway#MOST_BYTES}. JADE makes it by its class name.
 */
public final class BoundedLetters extends MessageTransportProtocol {
  private static final String LOOPBACK = "127.0.0.1";

  private final Map<String, Doorway> doorwayByAddress = new ConcurrentHashMap<>();

  @Override
  public void activate(InChannel.Dispatcher dispatcher, TransportAddress address, Profile profile)
      throws MTPException {
    try {
      int within = freePort();
      super.activate(dispatcher, strToAddr("http://" + LOOPBACK + ":" + within + "/acc"), profile);
      doorwayByAddress.put(
          addrToStr(address),
          Doorway.open(address.getHost(), Integer.parseInt(address.getPort()), within));
    } catch (IOException e) {
      throw new MTPException("Nothing can listen at " + addrToStr(address), e);
    }
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    }
  }

  @Override
  public void deactivate(TransportAddress address) throws MTPException {
    close();
    super.deactivate();
  }

  @Override
  public void deactivate() throws MTPException {
    close();
    super.deactivate();
  }

  private void close() {
    doorwayByAddress.values().forEach(Doorway::close);
    doorwayByAddress.clear();
  }
}
