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
 * A key that one has made for another, such as the main container for a process, or an agent for
 * one that refers to it: by it each of the two knows what comes from the other (ADE, 3.1; A24,
 * A27). It seals with HMAC-SHA-256. Immutable.
 */
public final class SessionKey {
  private static final String ALGORITHM = "HmacSHA256";
  private static final int BYTES = 32;

  private final String session;
  private final byte[] secret;

  /** What is sealed; a seal of one kind is none of another. */
  public enum Kind {
    /** A sign of life, from a process to the main container or from an agent to another. */
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

  public static SessionKey fresh() {
    byte[] secret = new byte[BYTES];
    new SecureRandom().nextBytes(secret);
    return new SessionKey(UUID.randomUUID().toString(), secret);
  }

  /** For the one whose key it is, and for nobody else. */
  public String write() {
    return session + " " + HexFormat.of().formatHex(secret);
  }

  /**
   * @throws IllegalArgumentException when it is none
   */
  public static SessionKey read(String written) {
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

  public Sealed seal(Kind kind, long number, String text) {
    return new Sealed(session, number, HexFormat.of().formatHex(code(kind, number, text)), text);
  }

  /** Whether it was sealed with this key, as that kind, and has not been changed since. */
  public boolean fits(Kind kind, Sealed sealed) {
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
