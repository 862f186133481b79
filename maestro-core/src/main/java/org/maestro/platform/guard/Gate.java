package org.maestro.platform.guard;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * A server socket that hands out only those who were let in. Strangers are dealt with beside it, a
 * few at a time, so that they hold nobody up.
 */
final class Gate extends ServerSocket {
  private static final int MOST_AT_THE_GATE = 32;
  private static final int IDLE_SECONDS = 10;
  private static final Duration LOOKED_EVERY = Duration.ofMillis(500);

  private final ServerSocket outside;
  private final Guard guard;
  private final BlockingQueue<Optional<Socket>> admitted = new LinkedBlockingQueue<>();
  private final ThreadPoolExecutor doorkeepers =
      new ThreadPoolExecutor(
          0,
          MOST_AT_THE_GATE,
          IDLE_SECONDS,
          TimeUnit.SECONDS,
          new SynchronousQueue<>(),
          work -> daemon(work, "gate-keeper"));
  private volatile boolean closed;

  /**
   * @param outside a plain one: who comes speaks TLS by the certificate that is good then
   */
  Gate(ServerSocket outside, Guard guard) throws IOException {
    this.outside = outside;
    this.guard = guard;
    daemon(this::open, "gate-" + outside.getLocalPort()).start();
    daemon(this::watch, "gate-watch-" + outside.getLocalPort()).start();
  }

  private void watch() {
    while (!closed) {
      LockSupport.parkNanos(LOOKED_EVERY.toNanos());
      guard.cutRevoked();
    }
  }

  private static Thread daemon(Runnable work, String name) {
    Thread thread = new Thread(work, name);
    thread.setDaemon(true);
    return thread;
  }

  private void open() {
    while (!closed) {
      try {
        Socket stranger = outside.accept();
        try {
          doorkeepers.execute(() -> receive(stranger));
        } catch (RejectedExecutionException tooMany) {
          stranger.close();
        }
      } catch (IOException e) {
        if (!closed) {
          guard
              .refusals()
              .log("Connections of other containers cannot be accepted: " + e.getMessage());
        }
      }
    }
  }

  private void receive(Socket stranger) {
    String from = stranger.getInetAddress().getHostAddress();
    try {
      Guard.Admission admission = guard.admit(stranger);
      if (admission.refusal().isPresent()) {
        refused(from, admission.refusal().get());
      } else if (admission.stays()) {
        admitted.add(Optional.of(admission.socket()));
        return;
      }
    } catch (EOFException gone) {
      refused(from, "it left before it had shown the join token");
    } catch (IOException none) {
      refused(from, "it shows no certificate of the site by TLS (" + none.getMessage() + ")");
    }
    try {
      stranger.close();
    } catch (IOException gone) {
      refused(from, "its connection could not be closed: " + gone.getMessage());
    }
  }

  private void refused(String from, String reason) {
    guard
        .refusals()
        .log(
            "A container at %s was refused at port %d: %s."
                .formatted(from, outside.getLocalPort(), reason));
  }

  @Override
  public Socket accept() throws IOException {
    try {
      return admitted.take().orElseThrow(() -> new SocketException("The gate is closed."));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new SocketException("Interrupted at the gate.");
    }
  }

  @Override
  public int getLocalPort() {
    return outside.getLocalPort();
  }

  @Override
  public InetAddress getInetAddress() {
    return outside.getInetAddress();
  }

  @Override
  public boolean isClosed() {
    return closed;
  }

  @Override
  public void close() throws IOException {
    closed = true;
    outside.close();
    doorkeepers.shutdownNow();
    admitted.add(Optional.empty());
  }
}
