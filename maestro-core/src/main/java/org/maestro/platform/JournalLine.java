package org.maestro.platform;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import java.util.zip.CRC32;

/**
 * One line of a journal: a JSON object whose first field is the line's number and whose last is the
 * checksum of what stands before it.
 */
final class JournalLine {
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final String NUMBER = "n";
  private static final String CHECKSUM = "crc";
  private static final String TAIL = ",\"" + CHECKSUM + "\":\"";
  private static final int TAIL_LENGTH = TAIL.length() + 10;

  private JournalLine() {}

  /** Without the line's end. */
  static String write(int number, ObjectNode fields) {
    ObjectNode numbered = JSON.createObjectNode().put(NUMBER, number);
    numbered.setAll(fields);
    String text = numbered.toString();
    String body = text.substring(0, text.length() - 1);
    return body + TAIL + checksum(body) + "\"}";
  }

  static JsonNode read(int number, String line) throws JournalDamage {
    int cut = line.length() - TAIL_LENGTH;
    if (cut < 1 || !line.startsWith(TAIL, cut) || !line.endsWith("\"}")) {
      throw new JournalDamage("it has no checksum at its end", true);
    }
    String body = line.substring(0, cut);
    String said = line.substring(cut + TAIL.length(), line.length() - 2);
    if (!said.equals(checksum(body))) {
      throw new JournalDamage("its checksum is another", false);
    }
    try {
      JsonNode fields = JSON.readTree(line);
      if (fields.path(NUMBER).asInt() != number) {
        throw new JournalDamage(
            "it says that it is line " + fields.path(NUMBER).asInt() + ", so lines are missing",
            false);
      }
      return fields;
    } catch (JsonProcessingException unreadable) {
      throw new JournalDamage("it is no JSON", false);
    }
  }

  private static String checksum(String body) {
    CRC32 checksum = new CRC32();
    checksum.update(body.getBytes(UTF_8));
    return String.format(Locale.ROOT, "%08x", checksum.getValue());
  }
}
