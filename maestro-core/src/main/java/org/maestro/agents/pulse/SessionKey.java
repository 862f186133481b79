package org.maestro.agents.pulse;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static java.nio.charset.StandardCharsets.UTF_8;

import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.UUID;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/**
 * A key that the main container has made for one process, by which each of them knows what comes
 * from the other (ADE, 3.1; A24). It seals with HMAC-SHA-256. Immutable.
 */
final class SessionKey {
  private static final String ALGORITHM = "HmacSHA256";
  private static final int BYTES = 32;

  private final String session;
  private final byte[] secret;

  /** What is sealed; a seal of one kind is none of another. */
  enum Kind {
    /** From a process to the main container. */
    BEAT,
    /** The answer to the beat of the same number. */
    CONFIRMATION,
    /** From the main container to a process. */
    ORDER
  }

  private SessionKey(String session, byte[] secret) {
    this.session = session;
    this.secret = secret;
  }

  static SessionKey fresh() {
    byte[] secret = new byte[BYTES];
    new SecureRandom().nextBytes(secret);
    return new SessionKey(UUID.randomUUID().toString(), secret);
  }

  /** For the process whose key it is, and for nobody else. */
  String write() {
    return session + " " + HexFormat.of().formatHex(secret);
  }

  /**
   * @throws IllegalArgumentException when it is none
   */
  static SessionKey read(String written) {
    String[] words = written.split(" ", -1);
    if (words.length != 2) {
      throw new IllegalArgumentException("What was told is no key of a session.");
    }
    return new SessionKey(words[0], HexFormat.of().parseHex(words[1]));
  }

  /** The name of the session, which is no secret. */
  String session() {
    return session;
  }

  Sealed seal(Kind kind, long number, String text) {
    return new Sealed(session, number, HexFormat.of().formatHex(code(kind, number, text)), text);
  }

  /** Whether it was sealed with this key, as that kind, and has not been changed since. */
  boolean fits(Kind kind, Sealed sealed) {
    byte[] expected =
        HexFormat.of().formatHex(code(kind, sealed.number(), sealed.text())).getBytes(US_ASCII);
    return sealed.session().equals(session)
        && MessageDigest.isEqual(expected, sealed.seal().getBytes(US_ASCII));
  }

  private byte[] code(Kind kind, long number, String text) {
    try {
      Mac mac = Mac.getInstance(ALGORITHM);
      mac.init(new SecretKeySpec(secret, ALGORITHM));
      mac.update("%s %s %d\n".formatted(kind, session, number).getBytes(UTF_8));
      return mac.doFinal(text.getBytes(UTF_8));
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("This Java has no " + ALGORITHM, e);
    }
  }
}
