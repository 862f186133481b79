package org.maestro.rats.faults;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.regex.Matcher;

/** Turns a valid payload into a broken one, by chance. */
final class Mutations {

  private static final List<String> ODD =
      List.of(
          "null",
          "true",
          "-1",
          "1e999",
          "\"\"",
          "\"+\"",
          "\"#\"",
          "\"a/b\"",
          "[]",
          "{}",
          "[[[]]]",
          "\"\\u0000\"",
          "99999999999999999999",
          "\"../..\"",
          "{\"ref\":7}",
          "0.5",
          "\"$share/x/#\"");

  private static final int MEGABYTE = 1 << 20;
  private static final int DEEP = 1_000;

  private final Random chance;

  Mutations(Random chance) {
    this.chance = chance;
  }

  byte[] of(byte[] valid) {
    return switch (chance.nextInt(9)) {
      case 0 -> truncated(valid);
      case 1 -> flipped(valid);
      case 2 -> inserted(valid);
      case 3, 4, 5 -> oddValue(valid);
      case 6 -> fieldRenamed(valid);
      case 7 -> chance.nextInt(200) == 0 ? huge() : twice(valid);
      default -> chance.nextInt(10) == 0 ? deep() : noise();
    };
  }

  private byte[] truncated(byte[] valid) {
    return Arrays.copyOf(valid, chance.nextInt(valid.length));
  }

  private byte[] flipped(byte[] valid) {
    byte[] bytes = valid.clone();
    for (int flip = 0; flip <= chance.nextInt(4); flip++) {
      bytes[chance.nextInt(bytes.length)] ^= (byte) (1 << chance.nextInt(8));
    }
    return bytes;
  }

  private byte[] inserted(byte[] valid) {
    String text = new String(valid, UTF_8);
    int at = chance.nextInt(text.length());
    return (text.substring(0, at) + ODD.get(chance.nextInt(ODD.size())) + text.substring(at))
        .getBytes(UTF_8);
  }

  /** Puts an odd value where some field's is. */
  private byte[] oddValue(byte[] valid) {
    String text = new String(valid, UTF_8);
    String[] parts = text.split("(?<=\":)", -1);
    int field = 1 + chance.nextInt(Math.max(1, parts.length - 1));
    if (field >= parts.length) {
      return noise();
    }
    parts[field] =
        parts[field].replaceFirst(
            "^(\"[^\"]*\"|[^,}\\]]*)",
            Matcher.quoteReplacement(ODD.get(chance.nextInt(ODD.size()))));
    return String.join("", parts).getBytes(UTF_8);
  }

  private byte[] fieldRenamed(byte[] valid) {
    String text = new String(valid, UTF_8);
    int at = text.indexOf('"', chance.nextInt(text.length()));
    return (at < 0 ? text : text.substring(0, at + 1) + "x" + text.substring(at + 1))
        .getBytes(UTF_8);
  }

  private static byte[] twice(byte[] valid) {
    String text = new String(valid, UTF_8);
    return (text + text).getBytes(UTF_8);
  }

  private static byte[] huge() {
    return ("{\"v\":\"1.0\",\"id\":\"x\",\"pad\":\"" + "a".repeat(MEGABYTE) + "\"}")
        .getBytes(UTF_8);
  }

  private static byte[] deep() {
    return ("{\"v\":\"1.0\",\"p\":" + "[".repeat(DEEP) + "]".repeat(DEEP) + "}").getBytes(UTF_8);
  }

  private byte[] noise() {
    byte[] bytes = new byte[1 + chance.nextInt(200)];
    chance.nextBytes(bytes);
    return bytes;
  }
}
