package org.maestro.platform.wires;

import jade.core.Profile;
import jade.imtp.leap.JICP.Connection;
import jade.imtp.leap.JICP.ConnectionFactory;
import jade.mtp.TransportAddress;
import java.io.IOException;
import java.net.ConnectException;
import java.net.Socket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The connections that the containers of one platform in this process have made. Thread-safe. */
public final class Wires {
  private static final Logger LOG = LoggerFactory.getLogger(Wires.class);

  /** Until then JADE has tried again, and believed that nobody is there. */
  private static final Duration BARRED = Duration.ofSeconds(30);

  /** So many connections to one address are looked through for closed ones. */
  private static final int MANY = 64;

  /** Many more than hosts begin at the same moment, and each is a thread of JADE's. */
  private static final int MOST_NEWCOMERS = 128;

  private final Newcomers newcomers = new Newcomers(MOST_NEWCOMERS);
  private final Map<String, List<Connection>> openByAddress = new HashMap<>();
  private final Map<String, Long> barredByAddress = new HashMap<>();

  /** The factory of connections to addresses. */
  public interface Maker {
    Connection make(TransportAddress address) throws IOException;
  }

  /**
   * Closes what is open to an address, and lets nothing be opened to it for half a minute: who
   * waits for an answer from there fails at once.
   *
   * @param address {@code host:port}
   */
  public void cut(String address) {
    List<Connection> open;
    synchronized (this) {
      barredByAddress.put(address, System.nanoTime());
      open = openByAddress.remove(address);
    }
    if (open != null) {
      open.forEach(Wires::close);
    }
  }

  /**
   * Begins a main container. Its port answers before its own agents are there, and the container of
   * another process that joined in between would break it: who comes early waits at the door.
   */
  public <T> T beforeOthers(Supplier<T> beginning) {
    newcomers.hold();
    try {
      return beginning.get();
    } finally {
      newcomers.letIn();
    }
  }

  private static void close(Connection connection) {
    try {
      connection.close();
    } catch (IOException e) {
      LOG.debug("A connection was closed already", e);
    }
  }

  /** Those that a container is to use; its own when nobody shares any with it. */
  public static Wires of(Profile profile) {
    return profile instanceof WiredProfile wired ? wired.wires() : new Wires();
  }

  /** Makes connections that can be cut; those that others make end with who made them. */
  public ConnectionFactory factory(Maker maker) {
    return new ConnectionFactory() {
      @Override
      public Connection createConnection(Socket socket) {
        return new IncomingConnection(socket, newcomers);
      }

      @Override
      public Connection createConnection(TransportAddress address) throws IOException {
        String to = address.getHost() + ":" + address.getPort();
        refuseBarred(to);
        Connection connection = maker.make(address);
        keep(to, connection);
        return connection;
      }
    };
  }

  private synchronized void refuseBarred(String address) throws ConnectException {
    Long since = barredByAddress.get(address);
    if (since != null) {
      if (System.nanoTime() - since < BARRED.toNanos()) {
        throw new ConnectException("The container at " + address + " has been given up");
      }
      barredByAddress.remove(address);
    }
  }

  /** One that was made while the address was being cut is cut too. */
  private void keep(String address, Connection connection) throws ConnectException {
    synchronized (this) {
      List<Connection> open = openByAddress.computeIfAbsent(address, a -> new ArrayList<>());
      open.add(connection);
      if (open.size() > MANY) {
        open.removeIf(Wires::isClosed);
      }
    }
    try {
      refuseBarred(address);
    } catch (ConnectException e) {
      close(connection);
      throw e;
    }
  }

  private static boolean isClosed(Connection connection) {
    return connection instanceof CuttableConnection cuttable && cuttable.isClosed();
  }
}
