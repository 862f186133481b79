package org.maestro.console.access;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.time.Duration;
import java.time.InstantSource;
import java.util.Base64;
import java.util.Locale;
import java.util.Optional;
import org.maestro.rats.security.Role;
import org.maestro.rats.security.SitePersons;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A secured site: persons sign in, or programs bring a name and a password with each request. Each
 * may what the site's files say that her role is, now.
 */
public final class PersonsAccess implements Access {
  private static final Logger LOG = LoggerFactory.getLogger(PersonsAccess.class);
  private static final String BASIC = "basic ";

  /** A password takes a tenth of a second of a processor, and may be guessed at. */
  private static final int GUESSES = 10;

  private static final Duration GUESS = Duration.ofSeconds(6);

  /** A page asks some thirty times when it is opened. */
  private static final int REQUESTS = 200;

  private static final Duration REQUEST = Duration.ofMillis(20);

  private final SitePersons persons;
  private final Sessions sessions;
  private final RateLimit guesses;
  private final RateLimit requests;

  /**
   * @param clock on the wall
   */
  public PersonsAccess(SitePersons persons, InstantSource clock) {
    this.persons = persons;
    this.sessions = new Sessions(clock);
    this.guesses = new RateLimit(GUESSES, GUESS, clock);
    this.requests = new RateLimit(REQUESTS, REQUEST, clock);
  }

  @Override
  public boolean isSecured() {
    return true;
  }

  @Override
  public Visit admit(Presented presented, Optional<Role> needed) {
    Visit visit = visit(presented);
    if (needed.isEmpty()) {
      return visit;
    }
    String person =
        visit
            .person()
            .orElseThrow(
                () ->
                    new DeniedException(
                        DeniedException.Reason.UNKNOWN,
                        "This site is secured: sign in first, or send a name and a password with each request (HTTP Basic)."));
    requests
        .take(person)
        .ifPresent(
            wait -> {
              throw DeniedException.until(wait);
            });
    if (visit.role().filter(role -> role.includes(needed.get())).isEmpty()) {
      throw new DeniedException(
          DeniedException.Reason.FORBIDDEN,
          "%s is %s here, and this takes %s; who keeps the site's files can change that: ./maestro secure DIR --%s %s"
              .formatted(
                  person,
                  visit.role().map(PersonsAccess::aRole).orElse("nobody"),
                  aRole(needed.get()),
                  needed.get().word(),
                  person));
    }
    return visit;
  }

  private static String aRole(Role role) {
    return (role == Role.VIEWER ? "a " : "an ") + role.name().toLowerCase(Locale.ROOT);
  }

  private Visit visit(Presented presented) {
    if (presented.authorization().isPresent()) {
      return byPassword(presented.authorization().get(), presented.address());
    }
    Optional<Session> session = presented.session().flatMap(sessions::use);
    if (session.isEmpty()) {
      return Visit.OF_NOBODY;
    }
    if (persons.role(session.get().person()).isEmpty()) {
      sessions.end(session.get());
      return Visit.OF_NOBODY;
    }
    if (presented.changes() && !isSame(session.get().csrf(), presented.csrf().orElse(""))) {
      throw new DeniedException(
          DeniedException.Reason.FORBIDDEN,
          "The request lacks the session's own token, so another page may have sent it; send it as X-CSRF-Token, as GET /session tells it.");
    }
    return of(session.get());
  }

  private Visit of(Session session) {
    return new Visit(
        Optional.of(session.person()),
        persons.role(session.person()),
        Optional.of(session),
        () ->
            sessions.use(session.token()).isPresent()
                && persons.role(session.person()).isPresent());
  }

  private Visit byPassword(String authorization, String address) {
    String[] named = decoded(authorization).split(":", 2);
    if (named.length != 2) {
      throw new DeniedException(
          DeniedException.Reason.UNKNOWN,
          "The header Authorization has to be HTTP Basic, with a name and a password.");
    }
    require(named[0], named[1], address);
    return new Visit(
        Optional.of(named[0]),
        persons.role(named[0]),
        Optional.empty(),
        () -> persons.role(named[0]).isPresent());
  }

  private static String decoded(String authorization) {
    if (!authorization.regionMatches(true, 0, BASIC, 0, BASIC.length())) {
      return "";
    }
    try {
      return new String(
          Base64.getDecoder().decode(authorization.substring(BASIC.length()).strip()),
          StandardCharsets.UTF_8);
    } catch (IllegalArgumentException unreadable) {
      return "";
    }
  }

  @Override
  public Visit signIn(String name, String password, String address) {
    require(name, password, address);
    LOG.info("{} signed in from {}", name, address);
    return of(sessions.begin(name));
  }

  private void require(String name, String password, String address) {
    if (persons.isProven(name, password)) {
      return;
    }
    guesses
        .take(address)
        .ifPresent(
            wait -> {
              throw DeniedException.until(wait);
            });
    if (!persons.isPassword(name, password)) {
      LOG.warn("Somebody at {} gave a wrong name or password", address);
      throw new DeniedException(
          DeniedException.Reason.UNKNOWN,
          "The name or the password is wrong; the site's files have it: users/NAME/console-password.");
    }
    guesses.giveBack(address);
  }

  @Override
  public void signOut(Visit visit) {
    visit.session().ifPresent(sessions::end);
  }

  private static boolean isSame(String one, String other) {
    return MessageDigest.isEqual(
        one.getBytes(StandardCharsets.UTF_8), other.getBytes(StandardCharsets.UTF_8));
  }
}
