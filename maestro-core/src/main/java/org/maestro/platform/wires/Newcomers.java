package org.maestro.platform.wires;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.net.Socket;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.Set;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Connections that others have made, and over which nothing has come yet that can be read. There
 * are so many at most; of more the oldest is let go, since a container speaks as soon as it is
 * connected. Nobody is listened to while they are held at the door. Thread-safe.
 */
final class Newcomers {
  private static final Logger LOG = LoggerFactory.getLogger(Newcomers.class);

  private final int most;
  private final Set<Socket> silent = new LinkedHashSet<>();
  private boolean crowded;
  private boolean held;

  Newcomers(int most) {
    this.most = most;
  }

  synchronized void hold() {
    held = true;
  }

  synchronized void letIn() {
    held = false;
    notifyAll();
  }

  /**
   * Returns once nobody is held any more.
   *
   * @throws InterruptedIOException when the thread is interrupted before that
   */
  synchronized void awaitEntry() throws InterruptedIOException {
    try {
      while (held) {
        wait();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("Interrupted at the door.");
    }
  }

  /** It was made just now. */
  void enter(Socket socket) {
    oldestOfTooMany(socket).forEach(Newcomers::letGo);
  }

  private synchronized Set<Socket> oldestOfTooMany(Socket socket) {
    silent.add(socket);
    Set<Socket> gone = new LinkedHashSet<>();
    Iterator<Socket> oldest = silent.iterator();
    while (silent.size() - gone.size() > most) {
      gone.add(oldest.next());
    }
    silent.removeAll(gone);
    if (!gone.isEmpty() && !crowded) {
      crowded = true;
      LOG.warn(
          "More than {} connections at once say nothing, the last one from {}: the oldest of them"
              + " are let go, as long as that lasts.",
          most,
          socket.getInetAddress());
    }
    return gone;
  }

  private static void letGo(Socket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      LOG.debug("A connection was closed already", e);
    }
  }

  /** Something has come over it, or it has ended. */
  synchronized void leave(Socket socket) {
    silent.remove(socket);
    crowded &= !silent.isEmpty();
  }
}
