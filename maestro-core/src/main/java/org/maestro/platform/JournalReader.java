package org.maestro.platform;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.maestro.coordination.JournalImage;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads a journal's file. What a writer was at when it died is left away; a line that was whole
 * once and is damaged now is an error, for who lost it could do a step twice.
 */
final class JournalReader {
  private static final Logger LOG = LoggerFactory.getLogger(JournalReader.class);

  private final Path file;
  private final JournalCodec codec;

  JournalReader(Path file, JournalCodec codec) {
    this.file = file;
    this.codec = codec;
  }

  /**
   * @param to the times in which the entries are wanted
   * @throws PlatformStartException when a line is damaged
   */
  JournalImage read(Timeline to) throws IOException {
    if (!Files.exists(file) || Files.size(file) == 0) {
      return new JournalImage(0);
    }
    String text = new String(Files.readAllBytes(file), UTF_8);
    List<String> lines = List.of(text.split("\n", -1));
    boolean lastIsEnded = lines.get(lines.size() - 1).isEmpty();
    int count = lastIsEnded ? lines.size() - 1 : lines.size();
    try {
      JsonNode header = JournalLine.read(1, lines.get(0));
      Timeline from = JournalDisk.timeline(header);
      JournalImage image = new JournalImage(JournalDisk.lastGoal(header));
      for (int number = 2; number <= count; number++) {
        try {
          image.add(codec.read(JournalLine.read(number, lines.get(number - 1)), from, to));
        } catch (JournalDamage damage) {
          if (number < count || !damage.isIncomplete() && lastIsEnded) {
            throw damaged(number, damage);
          }
          LOG.warn(
              "The last line ({}) of the journal {} was not written to its end and is left away",
              number,
              file);
        }
      }
      return image;
    } catch (JournalDamage damage) {
      throw damaged(1, damage);
    }
  }

  private PlatformStartException damaged(int line, JournalDamage damage) {
    return new PlatformStartException(
        "The journal %s is damaged in line %d: %s; put the line right from a copy, or move the file away to start without the goals in it."
            .formatted(file, line, damage.getMessage()),
        damage);
  }
}
