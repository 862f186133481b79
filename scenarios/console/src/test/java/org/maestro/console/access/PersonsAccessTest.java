package org.maestro.console.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.rats.security.Role;
import org.maestro.rats.security.SecureSite;
import org.maestro.rats.security.SiteSecurity;
import org.maestro.rats.security.SiteUsers;

class PersonsAccessTest {
  private static final String HERE = "127.0.0.1";
  private static final Optional<Role> VIEWER = Optional.of(Role.VIEWER);

  @TempDir static Path files;

  private Instant now = Instant.EPOCH;
  private final InstantSource clock = () -> now;
  private final PersonsAccess access = new PersonsAccess(SiteSecurity.open(files).persons(), clock);

  @BeforeAll
  static void make() {
    SecureSite.in(files)
        .make(
            new SiteUsers(
                "home",
                List.of(HERE),
                new TreeSet<>(List.of("maestro")),
                new TreeSet<>(),
                new TreeSet<>(),
                new TreeSet<>(),
                new TreeMap<>(Map.of("alice", Role.VIEWER, "bob", Role.VIEWER))));
  }

  private static String password() {
    return password("alice");
  }

  private static String password(String person) {
    return SiteSecurity.open(files).console(person).orElseThrow().password().orElseThrow();
  }

  private static Presented with(Session session) {
    return new Presented(
        HERE, Optional.empty(), Optional.of(session.token()), Optional.empty(), false, false);
  }

  private Session signIn() {
    return access.signIn("alice", password(), HERE).session().orElseThrow();
  }

  private void pass(Duration time) {
    now = now.plus(time);
  }

  @Test
  void passwordsAreGuessedTenTimesAtOnceAndThenTenTimesAMinute() {
    // She is known again at once from then on; wrong ones count all the same.
    signIn();
    for (int guess = 0; guess < 10; guess++) {
      assertDenied("guess-" + guess, DeniedException.Reason.UNKNOWN);
    }
    assertDenied("guess-10", DeniedException.Reason.TOO_OFTEN);
    assertDenied(password(), DeniedException.Reason.TOO_OFTEN);
    assertThat(access.signIn("alice", password(), "192.0.2.7").person())
        .as("from elsewhere she still can")
        .contains("alice");
    pass(Duration.ofSeconds(6));
    assertDenied("guess-11", DeniedException.Reason.UNKNOWN);
    assertDenied("guess-12", DeniedException.Reason.TOO_OFTEN);
  }

  private void assertDenied(String password, DeniedException.Reason reason) {
    assertThatThrownBy(() -> access.signIn("alice", password, HERE))
        .isInstanceOfSatisfying(
            DeniedException.class, denial -> assertThat(denial.reason()).isEqualTo(reason));
  }

  @Test
  void whoSignsInOftenIsNotTakenForAGuesser() {
    for (int time = 0; time < 40; time++) {
      assertThat(signIn().person()).isEqualTo("alice");
    }
  }

  @Test
  void manyThatComeAtOnceWithTheRightPasswordAreLetIn() throws Exception {
    ExecutorService threads = Executors.newFixedThreadPool(16);
    try {
      List<Callable<Optional<String>>> all =
          Collections.nCopies(30, () -> access.signIn("alice", password(), HERE).person());
      for (Future<Optional<String>> one : threads.invokeAll(all)) {
        assertThat(one.get()).contains("alice");
      }
    } finally {
      threads.shutdownNow();
    }
  }

  @Test
  void oneWhoSignsInAgainAndAgainEndsOnlyHerOwnSessions() {
    Session others = access.signIn("bob", password("bob"), HERE).session().orElseThrow();
    Session first = signIn();
    Session second = signIn();
    for (int more = 0; more < 18; more++) {
      signIn();
    }
    assertThat(access.admit(with(first), VIEWER).person()).contains("alice");
    signIn();
    assertThat(access.admit(with(first), VIEWER).person()).contains("alice");
    assertThat(access.admit(with(second), Optional.empty()).person())
        .as("it was used longest ago")
        .isEmpty();
    assertThat(access.admit(with(others), VIEWER).person()).contains("bob");
  }

  @Test
  void aSessionOfAFormerPasswordIsNoneThoughThePersonHasComeBack() {
    Session session = access.signIn("bob", password("bob"), HERE).session().orElseThrow();
    SecureSite.in(files).renew(List.of("bob"));
    assertThat(access.admit(with(session), Optional.empty()).person()).isEmpty();
    Session renewed = access.signIn("bob", password("bob"), HERE).session().orElseThrow();
    SecureSite.in(files).revoke(List.of("bob"));
    make();
    assertThat(access.admit(with(renewed), Optional.empty()).person()).isEmpty();
  }

  @Test
  void whatIsUrgentIsAnsweredHoweverMuchElseIsAsked() {
    Session session = signIn();
    for (int request = 0; request < 200; request++) {
      access.admit(with(session), VIEWER);
    }
    assertThatThrownBy(() -> access.admit(with(session), VIEWER))
        .isInstanceOf(DeniedException.class);
    Presented urgent =
        new Presented(
            HERE, Optional.empty(), Optional.of(session.token()), Optional.empty(), false, true);
    assertThat(access.admit(urgent, VIEWER).person()).contains("alice");
  }

  @Test
  void aSessionLastsAsLongAsItIsUsedAndAWeekAtMost() {
    Session used = signIn();
    Session left = signIn();
    for (int hours = 0; hours < 6 * 24; hours += 8) {
      pass(Duration.ofHours(8));
      assertThat(access.admit(with(used), VIEWER).person()).contains("alice");
    }
    assertThat(access.admit(with(left), Optional.empty()).person()).isEmpty();
    pass(Duration.ofDays(1));
    pass(Duration.ofHours(1));
    assertThat(access.admit(with(used), Optional.empty()).person()).isEmpty();
  }

  @Test
  void aProgramThatAsksWithoutEndIsToldWhenToAskAgain() {
    Session session = signIn();
    assertThatThrownBy(
            () -> {
              for (int request = 0; request < 1_000; request++) {
                access.admit(with(session), VIEWER);
              }
            })
        .isInstanceOfSatisfying(
            DeniedException.class,
            denial -> {
              assertThat(denial.reason()).isEqualTo(DeniedException.Reason.TOO_OFTEN);
              assertThat(denial.again()).isPresent();
            });
    pass(Duration.ofSeconds(1));
    assertThat(access.admit(with(session), VIEWER).person()).contains("alice");
  }

  @Test
  void secretsAreNotInTexts() {
    Session session = signIn();
    assertThat(session.toString()).doesNotContain(session.token(), session.csrf());
    assertThat(with(session).toString()).doesNotContain(session.token());
  }
}
