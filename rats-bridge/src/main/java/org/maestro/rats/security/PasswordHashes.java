package org.maestro.rats.security;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.HexFormat;
import javax.crypto.SecretKeyFactory;
import javax.crypto.spec.PBEKeySpec;

/**
 * New passwords, and what brokers and the console keep of them: PBKDF2 in the ways of mosquitto and
 * Artemis.
 */
final class PasswordHashes {

  private static final SecureRandom RANDOM = new SecureRandom();
  private static final int PASSWORD_BYTES = 24;
  private static final int KEY_BITS = 512;

  /** Few, as the passwords are random: there is nothing to guess, and every connect pays. */
  private static final int ROUNDS = 1_000;

  /** Those of persons may be chosen by them, and be guessed at. */
  private static final int SLOW_ROUNDS = 100_000;

  private static final String SHA_512 = "PBKDF2WithHmacSHA512";
  private static final int MOSQUITTO_SALT_BYTES = 12;
  private static final int ARTEMIS_SALT_BYTES = 32;

  private PasswordHashes() {}

  static String newPassword() {
    return Base64.getUrlEncoder().withoutPadding().encodeToString(random(PASSWORD_BYTES));
  }

  /** As a line of mosquitto's password file has it. */
  static String mosquitto(String password) {
    return written(password, random(MOSQUITTO_SALT_BYTES), ROUNDS);
  }

  /** The same, made slowly. */
  static String slow(String password) {
    return written(password, random(MOSQUITTO_SALT_BYTES), SLOW_ROUNDS);
  }

  /** Whether that was written of the password; false, too, where it was not written here. */
  static boolean isOf(String password, String written) {
    String[] parts = written.split("\\$");
    if (parts.length != 5 || !parts[1].equals("7") || !parts[2].matches("[1-9]\\d{0,6}")) {
      return false;
    }
    try {
      String again =
          written(password, Base64.getDecoder().decode(parts[3]), Integer.parseInt(parts[2]));
      return MessageDigest.isEqual(bytes(again), bytes(written));
    } catch (IllegalArgumentException unreadable) {
      return false;
    }
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static String written(String password, byte[] salt, int rounds) {
    Base64.Encoder base64 = Base64.getEncoder();
    return "$7$%d$%s$%s"
        .formatted(
            rounds,
            base64.encodeToString(salt),
            base64.encodeToString(derived(SHA_512, password, salt, rounds)));
  }

  /** As Artemis's properties of users have it. */
  static String artemis(String password) {
    byte[] salt = random(ARTEMIS_SALT_BYTES);
    byte[] hash = derived("PBKDF2WithHmacSHA1", password, salt, ROUNDS);
    HexFormat hex = HexFormat.of().withUpperCase();
    return "ENC(%d:%s:%s)".formatted(ROUNDS, hex.formatHex(salt), hex.formatHex(hash));
  }

  private static byte[] random(int length) {
    byte[] bytes = new byte[length];
    RANDOM.nextBytes(bytes);
    return bytes;
  }

  private static byte[] derived(String algorithm, String password, byte[] salt, int rounds) {
    try {
      return SecretKeyFactory.getInstance(algorithm)
          .generateSecret(new PBEKeySpec(password.toCharArray(), salt, rounds, KEY_BITS))
          .getEncoded();
    } catch (GeneralSecurityException unable) {
      throw new SecurityFilesException("This Java does not know " + algorithm + ".", unable);
    }
  }
}
