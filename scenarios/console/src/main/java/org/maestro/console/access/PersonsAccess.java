package org.maestro.console.access;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.time.InstantSource;
import java.util.Base64;
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

  private final SitePersons persons;
  private final Sessions sessions;
  private final Passwords passwords;
  private final Limits limits;

  /**
   * @param clock on the wall
   */
  public PersonsAccess(SitePersons persons, InstantSource clock) {
    this.persons = persons;
    this.limits = new Limits(clock);
    this.sessions = new Sessions(clock, name -> persons.identity(name));
    this.passwords = new Passwords(persons, limits);
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
    requireToken(visit, presented);
    if (!presented.urgent()) {
      limits.request(person);
    }
    if (visit.role().filter(role -> role.includes(needed.get())).isEmpty()) {
      throw new DeniedException(
          DeniedException.Reason.FORBIDDEN,
          "%s is %s here, and this takes %s; who keeps the site's files can change that: ./maestro secure DIR --%s %s"
              .formatted(
                  person,
                  visit.role().map(PersonsAccess::inWords).orElse("nobody"),
                  inWords(needed.get()),
                  needed.get().word(),
                  person));
    }
    return visit;
  }

  private static String inWords(Role role) {
    return (role == Role.VIEWER ? "a " : "an ") + role.word();
  }

  private static void requireToken(Visit visit, Presented presented) {
    boolean isForged =
        presented.changes()
            && visit
                .session()
                .filter(session -> !isSame(session.csrf(), presented.csrf().orElse("")))
                .isPresent();
    if (isForged) {
      throw new DeniedException(
          DeniedException.Reason.FORBIDDEN,
          "The request lacks the session's own token, so another page may have sent it; send it as X-CSRF-Token, as GET /session tells it.");
    }
  }

  private static boolean isSame(String one, String other) {
    return MessageDigest.isEqual(
        one.getBytes(StandardCharsets.UTF_8), other.getBytes(StandardCharsets.UTF_8));
  }

  private Visit visit(Presented presented) {
    return presented.authorization().isPresent()
        ? byPassword(presented.authorization().get(), presented.address())
        : presented.session().flatMap(sessions::use).map(this::of).orElse(Visit.OF_NOBODY);
  }

  private Visit of(Session session) {
    return new Visit(
        Optional.of(session.person()),
        persons.role(session.person()),
        Optional.of(session),
        () -> sessions.use(session.token()).isPresent());
  }

  private Visit byPassword(String authorization, String address) {
    String[] named = decoded(authorization).split(":", 2);
    if (named.length != 2) {
      throw new DeniedException(
          DeniedException.Reason.UNKNOWN,
          "The header Authorization has to be HTTP Basic, with a name and a password.");
    }
    String name = named[0];
    String identity = passwords.require(name, named[1], address);
    return new Visit(
        Optional.of(name),
        persons.role(name),
        Optional.empty(),
        () -> persons.identity(name).filter(identity::equals).isPresent());
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
    String identity = passwords.require(name, password, address);
    limits.signIn(name);
    LOG.info("{} signed in from {}", name, address);
    return of(sessions.begin(name, identity));
  }

  @Override
  public void signOut(Visit visit) {
    visit.session().ifPresent(sessions::end);
  }
}
