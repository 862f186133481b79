package org.maestro.agents.pulse;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.rats.bounded.BoundedMap;

/**
 * The sessions of a main container with the processes of its platform: it makes the key of each,
 * and believes no sign of life that is not under its seal, comes a second time, or speaks of
 * containers of another process (ADE, 3.1; A24). Any thread may use it.
 */
final class Sessions {
  private static final int REMEMBERED = 10_000;

  /** The containers of the platform, as JADE has them: what is told to one nobody else hears. */
  interface Containers {
    /**
     * @param request by which the container knows that it has asked for the key
     * @throws IllegalArgumentException when there is no such container, or it has not asked
     */
    void tell(String container, String request, String key);

    /** The name of the session of its process; empty when it has none, or cannot be asked. */
    String session(String container);
  }

  private final Containers containers;
  private final Consumer<String> log;
  private final Map<String, Session> sessions = BoundedMap.ofLatelyUsed(REMEMBERED);
  private final Map<String, String> sessionByContainer = BoundedMap.ofNewest(REMEMBERED);
  private final Map<String, String> sessionByLife = BoundedMap.ofNewest(REMEMBERED);

  /** What was heard of it is guarded by itself, what it was ordered by all sessions. */
  private static final class Session {
    private final SessionKey key;
    private long heard;
    private long ordered;

    private Session(SessionKey key) {
      this.key = key;
    }
  }

  /**
   * @param log told in one sentence of what is refused
   */
  Sessions(Containers containers, Consumer<String> log) {
    this.containers = containers;
    this.log = log;
  }

  /**
   * Makes a key for the process of a container, and tells it to that container alone.
   *
   * @throws IllegalArgumentException when it does not take it
   */
  void begin(String container, String request) {
    SessionKey key = SessionKey.fresh();
    containers.tell(container, request, key.write());
    synchronized (this) {
      sessions.put(key.session(), new Session(key));
      sessionByContainer.put(container, key.session());
    }
  }

  /**
   * A sign of life comes in.
   *
   * @throws IllegalArgumentException when it is refused
   */
  Sealed heard(String written) {
    Sealed beat = Sealed.read(written);
    Session session = session(beat);
    if (!session.key.fits(SessionKey.Kind.BEAT, beat)) {
      throw refusal("A sign of life was refused: it is not under the seal of its session.");
    }
    synchronized (session) {
      if (beat.number() <= session.heard) {
        throw refusal("A sign of life was refused: it has come before.");
      }
      session.heard = beat.number();
    }
    return beat;
  }

  private synchronized Session session(Sealed beat) {
    return Optional.ofNullable(sessions.get(beat.session()))
        .orElseThrow(
            () -> new IllegalArgumentException("There is no such session; ask for a key."));
  }

  private IllegalArgumentException refusal(String sentence) {
    log.accept(sentence);
    return new IllegalArgumentException(sentence);
  }

  /** Those of some containers of a beat whose process has sealed it; the others were spoken for. */
  List<Beat.Living> own(Sealed beat, List<Beat.Living> some) {
    return some.stream().filter(living -> isOwn(beat.session(), living)).toList();
  }

  private boolean isOwn(String session, Beat.Living living) {
    synchronized (this) {
      if (session.equals(sessionByLife.get(living.life()))) {
        return true;
      }
    }
    if (!containers.session(living.name()).equals(session)) {
      log.accept(
          "A sign of life of the container %s was refused: its process has another session."
              .formatted(living.name()));
      return false;
    }
    synchronized (this) {
      sessionByLife.put(living.life(), session);
      sessionByContainer.put(living.name(), session);
    }
    return true;
  }

  /** The answer to a beat. */
  String confirm(Sealed beat, String confirmation) {
    return session(beat)
        .key
        .seal(SessionKey.Kind.CONFIRMATION, beat.number(), confirmation)
        .write();
  }

  /**
   * An order to a container.
   *
   * @throws IllegalStateException when its process has no session
   */
  synchronized String order(String container, String text) {
    Session session =
        Optional.ofNullable(sessionByContainer.get(container))
            .map(sessions::get)
            .orElseThrow(
                () ->
                    new IllegalStateException(
                        "The container %s has no session in which it could be ordered anything"
                            .formatted(container)));
    session.ordered++;
    return session.key.seal(SessionKey.Kind.ORDER, session.ordered, text).write();
  }
}
