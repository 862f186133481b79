package org.maestro.rats.security;

import java.security.GeneralSecurityException;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.HexFormat;
import javax.crypto.SecretKeyFactory;
import javax.crypto.spec.PBEKeySpec;

/** New passwords, and what brokers keep of them: PBKDF2 in the ways of mosquitto and Artemis. */
final class PasswordHashes {

  private static final SecureRandom RANDOM = new SecureRandom();
  private static final int PASSWORD_BYTES = 24;
  private static final int KEY_BITS = 512;

  /** Few, as the passwords are random: there is nothing to guess, and every connect pays. */
  private static final int ROUNDS = 1_000;

  private static final int MOSQUITTO_SALT_BYTES = 12;
  private static final int ARTEMIS_SALT_BYTES = 32;

  private PasswordHashes() {}

  static String newPassword() {
    return Base64.getUrlEncoder().withoutPadding().encodeToString(random(PASSWORD_BYTES));
  }

  /** As a line of mosquitto's password file has it. */
  static String mosquitto(String password) {
    byte[] salt = random(MOSQUITTO_SALT_BYTES);
    byte[] hash = derived("PBKDF2WithHmacSHA512", password, salt, ROUNDS);
    Base64.Encoder base64 = Base64.getEncoder();
    return "$7$%d$%s$%s"
        .formatted(ROUNDS, base64.encodeToString(salt), base64.encodeToString(hash));
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
