package org.maestro.console.access;

import java.time.Duration;
import java.time.InstantSource;
import java.util.Optional;

/** The limits to how often something is asked or tried, generous for people. Any thread. */
final class Limits {
  /** Wrong passwords of one name from one address. */
  private final RateLimit guesses;

  /** Wrong passwords from one address, of whatever names. */
  private final RateLimit guessesFromAddress;

  private final RateLimit signIns;
  private final RateLimit requests;

  /**
   * @param clock on the wall
   */
  Limits(InstantSource clock) {
    this.guesses = new RateLimit(10, Duration.ofSeconds(6), clock);
    this.guessesFromAddress = new RateLimit(60, Duration.ofSeconds(1), clock);
    this.signIns = new RateLimit(60, Duration.ofSeconds(1), clock);
    // A page asks some thirty times when it is opened.
    this.requests = new RateLimit(200, Duration.ofMillis(20), clock);
  }

  /**
   * Looks whether a password may be tried.
   *
   * @throws DeniedException when there were too many wrong ones
   */
  void guess(String name, String address) {
    deny(guesses.wouldWait(both(name, address)));
    deny(guessesFromAddress.wouldWait(address));
  }

  void wrongGuess(String name, String address) {
    guesses.take(both(name, address));
    guessesFromAddress.take(address);
  }

  void signIn(String person) {
    deny(signIns.take(person));
  }

  void request(String person) {
    deny(requests.take(person));
  }

  private static String both(String name, String address) {
    return address + " " + name;
  }

  private static void deny(Optional<Duration> wait) {
    if (wait.isPresent()) {
      throw DeniedException.until(wait.get());
    }
  }
}
