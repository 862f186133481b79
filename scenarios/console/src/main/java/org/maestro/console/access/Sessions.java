package org.maestro.console.access;

import java.security.SecureRandom;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Base64;
import java.util.Map;
import java.util.Optional;
import org.maestro.rats.bounded.BoundedMap;

/**
 * The sessions that have begun and not ended. One that nobody uses for twelve hours ends, and each
 * after a week; they end with the process, too. Any thread.
 */
final class Sessions {
  private static final Duration UNUSED = Duration.ofHours(12);
  private static final Duration LONGEST = Duration.ofDays(7);
  private static final int MOST = 1_000;
  private static final int TOKEN_BYTES = 32;

  private final InstantSource clock;
  private final SecureRandom random = new SecureRandom();
  private final Map<String, Known> all = BoundedMap.ofNewest(MOST);

  private record Known(Session session, Instant begun, Instant used) {
    private boolean isOverAt(Instant now) {
      return used.plus(UNUSED).isBefore(now) || begun.plus(LONGEST).isBefore(now);
    }
  }

  Sessions(InstantSource clock) {
    this.clock = clock;
  }

  synchronized Session begin(String person) {
    Session session = new Session(token(), person, token());
    Instant now = clock.instant();
    all.put(session.token(), new Known(session, now, now));
    return session;
  }

  /** The session of that token, which is used now. */
  synchronized Optional<Session> use(String token) {
    Known known = all.get(token);
    if (known == null) {
      return Optional.empty();
    }
    Instant now = clock.instant();
    if (known.isOverAt(now)) {
      all.remove(token);
      return Optional.empty();
    }
    all.replace(token, new Known(known.session(), known.begun(), now));
    return Optional.of(known.session());
  }

  synchronized void end(Session session) {
    all.remove(session.token());
  }

  private String token() {
    byte[] bytes = new byte[TOKEN_BYTES];
    random.nextBytes(bytes);
    return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
  }
}
