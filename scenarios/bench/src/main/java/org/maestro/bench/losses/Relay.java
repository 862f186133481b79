package org.maestro.bench.losses;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.locks.LockSupport;

/** Passes on what comes to an address, a little later if it is told to. Any thread may use it. */
final class Relay implements AutoCloseable {
  private static final int BYTES = 16 * 1024;

  private final ServerSocket server;
  private final URI to;
  private final List<Socket> open = new CopyOnWriteArrayList<>();
  private volatile Duration delay = Duration.ZERO;

  private Relay(ServerSocket server, URI to) {
    this.server = server;
    this.to = to;
  }

  static Relay listen(String address, URI to) {
    try {
      Relay relay = new Relay(new ServerSocket(0, 50, InetAddress.getByName(address)), to);
      daemon(relay::accept);
      return relay;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  URI uri() {
    String host = server.getInetAddress().getHostAddress();
    return URI.create(to.getScheme() + "://" + host + ":" + server.getLocalPort());
  }

  /** From now on everything comes so much later, each way. */
  void delay(Duration each) {
    delay = each;
  }

  private void accept() {
    try {
      while (true) {
        Socket from = server.accept();
        Socket on = new Socket(to.getHost(), to.getPort());
        from.setTcpNoDelay(true);
        on.setTcpNoDelay(true);
        open.addAll(List.of(from, on));
        daemon(() -> pass(from, on));
        daemon(() -> pass(on, from));
      }
    } catch (IOException e) {
      // It was closed, or nobody is there to pass on to.
    }
  }

  private void pass(Socket from, Socket on) {
    BlockingQueue<Due> line = new LinkedBlockingQueue<>();
    daemon(() -> deliver(line, on));
    try (from) {
      InputStream in = from.getInputStream();
      byte[] bytes = new byte[BYTES];
      for (int read = in.read(bytes); read >= 0; read = in.read(bytes)) {
        line.add(new Due(System.nanoTime() + delay.toNanos(), Arrays.copyOf(bytes, read)));
      }
    } catch (IOException e) {
      // This side is gone; the other is told by the end.
    }
    line.add(new Due(System.nanoTime(), new byte[0]));
  }

  /** Bytes on their way, and the time when they are there; no bytes are the end. */
  private record Due(long atNanos, byte[] bytes) {}

  private static void deliver(BlockingQueue<Due> line, Socket on) {
    try (on) {
      OutputStream out = on.getOutputStream();
      for (Due due = line.take(); due.bytes().length > 0; due = line.take()) {
        LockSupport.parkNanos(due.atNanos() - System.nanoTime());
        out.write(due.bytes());
        out.flush();
      }
    } catch (IOException e) {
      // The other side is gone.
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static void daemon(Runnable work) {
    Thread thread = new Thread(work, "relay");
    thread.setDaemon(true);
    thread.start();
  }

  @Override
  public void close() {
    try {
      server.close();
      for (Socket socket : open) {
        socket.close();
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
