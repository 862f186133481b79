package org.maestro.console.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import org.junit.jupiter.api.Test;

class LimitsTest {
  private Instant now = Instant.EPOCH;
  private final Limits limits = new Limits(() -> now);

  @Test
  void wrongPasswordsOfManyNamesFromOneAddressAreLimitedToo() {
    for (int name = 0; name < 60; name++) {
      limits.guess("name-" + name, "here");
      limits.wrongGuess("name-" + name, "here");
    }
    assertThatThrownBy(() -> limits.guess("another", "here"))
        .isInstanceOfSatisfying(
            DeniedException.class,
            denial -> assertThat(denial.again()).contains(Duration.ofSeconds(1)));
    assertThatCode(() -> limits.guess("another", "elsewhere")).doesNotThrowAnyException();
    now = now.plusSeconds(1);
    assertThatCode(() -> limits.guess("another", "here")).doesNotThrowAnyException();
  }

  @Test
  void oneNameIsGuessedTenTimesAndThenOnceInSixSeconds() {
    for (int guess = 0; guess < 10; guess++) {
      limits.guess("alice", "here");
      limits.wrongGuess("alice", "here");
    }
    assertThatThrownBy(() -> limits.guess("alice", "here")).isInstanceOf(DeniedException.class);
    assertThatCode(() -> limits.guess("bob", "here")).doesNotThrowAnyException();
    now = now.plusSeconds(6);
    assertThatCode(() -> limits.guess("alice", "here")).doesNotThrowAnyException();
    limits.wrongGuess("alice", "here");
    assertThatThrownBy(() -> limits.guess("alice", "here")).isInstanceOf(DeniedException.class);
  }
}
