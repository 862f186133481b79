package org.maestro.console.access;

import java.security.SecureRandom;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * The sessions that have begun and not ended. One that nobody uses for twelve hours ends, and each
 * after a week; they end with the process, too. One is good only as long as its person has the
 * password with which it began. Any thread.
 */
final class Sessions {
  private static final Duration UNUSED = Duration.ofHours(12);
  private static final Duration LONGEST = Duration.ofDays(7);

  /** More devices than a person has; her oldest session ends. */
  private static final int MOST_OF_A_PERSON = 20;

  private static final int TOKEN_BYTES = 32;

  private final InstantSource clock;
  private final Function<String, Optional<String>> identities;
  private final SecureRandom random = new SecureRandom();

  /** The one that was used longest ago first. */
  private final Map<String, Known> all = new LinkedHashMap<>();

  private record Known(Session session, String identity, Instant begun, Instant used) {
    private boolean isOverAt(Instant now) {
      return used.plus(UNUSED).isBefore(now) || begun.plus(LONGEST).isBefore(now);
    }
  }

  /**
   * @param identities what stands for a person with the password that she has now
   */
  Sessions(InstantSource clock, Function<String, Optional<String>> identities) {
    this.clock = clock;
    this.identities = identities;
  }

  /**
   * Begins one.
   *
   * @param identity what stands for her with the password that she gave
   */
  synchronized Session begin(String person, String identity) {
    Instant now = clock.instant();
    all.values().removeIf(known -> known.isOverAt(now));
    List<String> hers =
        all.values().stream()
            .filter(known -> known.session().person().equals(person))
            .map(known -> known.session().token())
            .toList();
    hers.stream().limit(Math.max(0, hers.size() - MOST_OF_A_PERSON + 1)).forEach(all::remove);
    Session session = new Session(token(), person, token());
    all.put(session.token(), new Known(session, identity, now, now));
    return session;
  }

  /** The session of that token, which is used now. */
  synchronized Optional<Session> use(String token) {
    Known known = all.remove(token);
    if (known == null) {
      return Optional.empty();
    }
    Instant now = clock.instant();
    if (known.isOverAt(now)) {
      return Optional.empty();
    }
    all.put(token, new Known(known.session(), known.identity(), known.begun(), now));
    // A file that is half written just now names nobody, and ends nothing.
    return identities
        .apply(known.session().person())
        .filter(known.identity()::equals)
        .map(hers -> known.session());
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
