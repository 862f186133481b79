package org.maestro.platform.journal;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import java.util.zip.CRC32;
import org.maestro.text.VisibleText;

/**
 * One line of a journal: a JSON object whose first field is the line's number, whose second is the
 * checksum of the line before, and whose last is the checksum of what stands before it. Lines of
 * older versions have no second.
 */
public final class JournalLine {
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final String NUMBER = "n";
  private static final String AFTER = "after";
  private static final String CHECKSUM = "crc";
  private static final String TAIL = ",\"" + CHECKSUM + "\":\"";
  private static final int TAIL_LENGTH = TAIL.length() + 10;

  private JournalLine() {}

  /**
   * Without the line's end.
   *
   * @param after the checksum of the line before; empty for the first
   */
  public static String write(int number, String after, ObjectNode fields) {
    ObjectNode numbered = JSON.createObjectNode().put(NUMBER, number).put(AFTER, after);
    numbered.setAll(fields);
    String text = VisibleText.line(numbered.toString());
    String body = text.substring(0, text.length() - 1);
    return body + TAIL + checksum(body) + "\"}";
  }

  /** Of a line that was read or written. */
  static String checksumOf(String line) {
    return line.substring(line.length() - TAIL_LENGTH + TAIL.length(), line.length() - 2);
  }

  public static JsonNode read(String line) throws JournalDamage {
    int cut = line.length() - TAIL_LENGTH;
    if (cut < 1 || !line.startsWith(TAIL, cut) || !line.endsWith("\"}")) {
      throw new JournalDamage("it has no checksum at its end", true);
    }
    String body = line.substring(0, cut);
    if (!checksumOf(line).equals(checksum(body))) {
      throw new JournalDamage("its checksum is another", false);
    }
    try {
      return JSON.readTree(line);
    } catch (JsonProcessingException unreadable) {
      throw new JournalDamage("it is no JSON", false);
    }
  }

  static int number(JsonNode fields) {
    return fields.path(NUMBER).asInt();
  }

  /** The checksum of the line before; empty when it does not say. */
  static String after(JsonNode fields) {
    return fields.path(AFTER).asText();
  }

  /** Whether the line follows the one with that checksum, as far as it says. */
  static boolean isAfter(JsonNode fields, String checksum) {
    return fields.path(AFTER).asText(checksum).equals(checksum);
  }

  private static String checksum(String body) {
    CRC32 checksum = new CRC32();
    checksum.update(body.getBytes(UTF_8));
    return String.format(Locale.ROOT, "%08x", checksum.getValue());
  }
}
