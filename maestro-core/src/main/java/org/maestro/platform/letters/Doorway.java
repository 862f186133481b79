package org.maestro.platform.letters;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicLong;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Hands on what comes from other platforms, message by message, as long as none is too large, few
 * come at once, and none is left hanging. Thread-safe.
 */
final class Doorway implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Doorway.class);

  /** Of one message with its envelope: a goal has some hundred. */
  static final long MOST_BYTES = 1L << 20;

  private static final int MOST_AT_ONCE = 32;
  private static final int SILENT_MILLIS = 60_000;
  private static final int CHUNK = 8_192;
  private static final byte[] TOO_LARGE =
      "HTTP/1.1 413 Content Too Large\r\nContent-Length: 0\r\nConnection: close\r\n\r\n"
          .getBytes(StandardCharsets.US_ASCII);

  private final ServerSocket outside;
  private final InetSocketAddress inside;
  private final Semaphore free = new Semaphore(MOST_AT_ONCE);
  private final Set<Socket> open = ConcurrentHashMap.newKeySet();

  private Doorway(ServerSocket outside, InetSocketAddress inside) {
    this.outside = outside;
    this.inside = inside;
  }

  /**
   * @param inside a port of loopback, at which messages are read
   * @throws IOException when the port outside is taken
   */
  static Doorway open(String host, int port, int inside) throws IOException {
    ServerSocket listening = new ServerSocket(port, MOST_AT_ONCE, InetAddress.getByName(host));
    Doorway doorway =
        new Doorway(listening, new InetSocketAddress(InetAddress.getLoopbackAddress(), inside));
    start(doorway::accept);
    return doorway;
  }

  int port() {
    return outside.getLocalPort();
  }

  private static void start(Runnable work) {
    Thread thread = new Thread(work, "maestro-letters");
    thread.setDaemon(true);
    thread.start();
  }

  private void accept() {
    while (!outside.isClosed()) {
      try {
        Socket sender = outside.accept();
        if (free.tryAcquire()) {
          start(() -> serve(sender));
        } else {
          LOG.warn("{} is turned away: {} others send now", sender.getInetAddress(), MOST_AT_ONCE);
          sender.close();
        }
      } catch (IOException e) {
        LOG.debug("Nobody is let in any more, or one has gone at once", e);
      }
    }
  }

  private void serve(Socket sender) {
    open.add(sender);
    try (sender;
        Socket reader = new Socket()) {
      open.add(reader);
      reader.connect(inside, SILENT_MILLIS);
      sender.setSoTimeout(SILENT_MILLIS);
      AtomicLong bytes = new AtomicLong();
      start(() -> answer(reader, sender, bytes));
      handOn(sender, reader, bytes);
      open.remove(reader);
    } catch (IOException e) {
      LOG.debug("A connection from another platform has ended", e);
    } finally {
      open.remove(sender);
      free.release();
    }
  }

  private static void handOn(Socket sender, Socket reader, AtomicLong bytes) throws IOException {
    InputStream in = sender.getInputStream();
    OutputStream out = reader.getOutputStream();
    byte[] chunk = new byte[CHUNK];
    for (int read = in.read(chunk); read >= 0; read = in.read(chunk)) {
      if (bytes.addAndGet(read) > MOST_BYTES) {
        LOG.warn(
            "A message from {} is refused: it is larger than {} bytes",
            sender.getInetAddress(),
            MOST_BYTES);
        sender.getOutputStream().write(TOO_LARGE);
        return;
      }
      out.write(chunk, 0, read);
    }
  }

  /** With its answer a message is over. */
  private static void answer(Socket reader, Socket sender, AtomicLong bytes) {
    byte[] chunk = new byte[CHUNK];
    try {
      InputStream in = reader.getInputStream();
      for (int read = in.read(chunk); read >= 0; read = in.read(chunk)) {
        bytes.set(0);
        sender.getOutputStream().write(chunk, 0, read);
      }
      sender.close();
    } catch (IOException e) {
      LOG.debug("Nobody waits for the answer any more", e);
    }
  }

  @Override
  public void close() {
    try {
      outside.close();
      for (Socket socket : open) {
        socket.close();
      }
    } catch (IOException e) {
      LOG.debug("A connection had ended already", e);
    }
  }
}
