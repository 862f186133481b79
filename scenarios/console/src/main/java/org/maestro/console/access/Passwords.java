package org.maestro.console.access;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.Collections;
import java.util.Map;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;
import org.maestro.rats.bounded.BoundedMap;
import org.maestro.rats.security.SitePersons;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The passwords that are presented: one that was found right is known again at once, by a digest
 * with a key of this process; others are hashed, one at a time, so that guessing takes neither all
 * processors nor many tries. Any thread; it may wait for a moment.
 */
final class Passwords {
  private static final Logger LOG = LoggerFactory.getLogger(Passwords.class);
  private static final String DIGEST = "HmacSHA256";
  private static final int KEY_BYTES = 32;
  private static final int MOST_PROVEN = 1_000;
  private static final Duration TURN_WITHIN = Duration.ofSeconds(3);

  private final SitePersons persons;
  private final Limits limits;
  private final SecretKeySpec key;
  private final Semaphore turn = new Semaphore(1, true);
  private final Map<String, Proven> proven =
      Collections.synchronizedMap(BoundedMap.ofLatelyUsed(MOST_PROVEN));

  private record Proven(String identity, byte[] digest) {}

  Passwords(SitePersons persons, Limits limits) {
    this.persons = persons;
    this.limits = limits;
    byte[] bytes = new byte[KEY_BYTES];
    new SecureRandom().nextBytes(bytes);
    this.key = new SecretKeySpec(bytes, DIGEST);
  }

  /**
   * Makes sure that the password is hers; returns what stands for her with that password.
   *
   * @throws DeniedException when it is not, or wrong ones were tried too often
   */
  String require(String name, String password, String address) {
    limits.guess(name, address);
    String identity = persons.identity(name).orElse("");
    if (isProven(name, identity, password)) {
      return identity;
    }
    awaitTurn();
    try {
      limits.guess(name, address);
      if (!isProven(name, identity, password) && !persons.isPassword(name, password)) {
        limits.wrongGuess(name, address);
        LOG.warn("Somebody at {} gave a wrong name or password", address);
        throw new DeniedException(
            DeniedException.Reason.UNKNOWN,
            "The name or the password is wrong; the site's files have it: users/NAME/console-password.");
      }
      proven.put(name, new Proven(identity, digest(password)));
      return identity;
    } finally {
      turn.release();
    }
  }

  private void awaitTurn() {
    try {
      if (!turn.tryAcquire(TURN_WITHIN.toMillis(), TimeUnit.MILLISECONDS)) {
        throw DeniedException.until(TURN_WITHIN);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw DeniedException.until(TURN_WITHIN);
    }
  }

  private boolean isProven(String name, String identity, String password) {
    Proven before = proven.get(name);
    return before != null
        && before.identity().equals(identity)
        && MessageDigest.isEqual(before.digest(), digest(password));
  }

  private byte[] digest(String password) {
    try {
      Mac mac = Mac.getInstance(DIGEST);
      mac.init(key);
      return mac.doFinal(password.getBytes(StandardCharsets.UTF_8));
    } catch (GeneralSecurityException unable) {
      throw new IllegalStateException("This Java does not know " + DIGEST + ".", unable);
    }
  }
}
