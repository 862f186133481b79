package org.maestro.agents.pulse;

import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.UUID;

/**
 * The session of a process with the main container: what it says is sealed by the key that it was
 * given, and what it is answered and ordered counts only under the seal of that key (ADE, 3.1; A23,
 * A24). Any thread may use it.
 */
final class ProcessSession {
  private static final int REMEMBERED = 100;

  /** All guarded by this. */
  private Optional<SessionKey> key = Optional.empty();

  private Optional<String> awaited = Optional.empty();
  private long sent;

  /** The numbers of the latest orders, which may overtake each other. */
  private final SortedSet<Long> obeyed = new TreeSet<>();

  /**
   * A key is asked for.
   *
   * @return what has to come with it: nobody but who was asked knows it
   */
  synchronized String await() {
    String request = UUID.randomUUID().toString();
    awaited = Optional.of(request);
    return request;
  }

  /**
   * The key has come.
   *
   * @throws IllegalArgumentException when it is not what was asked for
   */
  synchronized void begin(String request, String written) {
    if (!awaited.equals(Optional.of(request))) {
      throw new IllegalArgumentException("A key was told that nobody has asked for.");
    }
    key = Optional.of(SessionKey.read(written));
    awaited = Optional.empty();
    sent = 0;
    obeyed.clear();
  }

  /** Who is not answered as he should be asks for another key. */
  synchronized void end() {
    key = Optional.empty();
  }

  /** The name of the session that there is now. */
  synchronized Optional<String> name() {
    return key.map(SessionKey::session);
  }

  /**
   * @throws IllegalArgumentException when there is no session
   */
  synchronized String seal(String beat) {
    sent++;
    return known().seal(SessionKey.Kind.BEAT, sent, beat).write();
  }

  /**
   * The answer to the latest beat.
   *
   * @throws IllegalArgumentException when it is not that
   */
  synchronized String confirmed(String written) {
    Sealed answer = Sealed.read(written);
    if (answer.number() != sent || !known().fits(SessionKey.Kind.CONFIRMATION, answer)) {
      throw new IllegalArgumentException(
          "A confirmation is not that of the latest sign of life, or not the main container's.");
    }
    return answer.text();
  }

  /**
   * The main container orders something.
   *
   * @throws IllegalArgumentException when it is somebody else, or the order has come before
   */
  synchronized String ordered(String written) {
    Sealed order = Sealed.read(written);
    if (!known().fits(SessionKey.Kind.ORDER, order)) {
      throw new IllegalArgumentException("An order is not the main container's.");
    }
    boolean isOld = obeyed.size() == REMEMBERED && order.number() < obeyed.first();
    if (isOld || !obeyed.add(order.number())) {
      throw new IllegalArgumentException("An order has come before.");
    }
    if (obeyed.size() > REMEMBERED) {
      obeyed.remove(obeyed.first());
    }
    return order.text();
  }

  private SessionKey known() {
    return key.orElseThrow(
        () -> new IllegalArgumentException("There is no session with the main container."));
  }
}
