package org.maestro.platform.journal;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;

/**
 * The length of a journal when it was last forced to the disk, in a file beside it: a journal that
 * was cut at the end of a line looks whole. The mark is written after what it speaks of, so a
 * process that dies between leaves one that says less than is there, never more.
 *
 * @param generation how often the journal has been replaced as a whole
 * @param lines that were certain
 * @param checksum of the last of them
 */
record JournalMark(int generation, int lines, String checksum) {
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final String GENERATION = "generation";

  /** Always as many bytes: written over the former, they need no room on a full disk. */
  private static final int BYTES = 128;

  static Path file(Path journal) {
    return journal.resolveSibling("journal.mark");
  }

  /**
   * The mark beside a journal; empty when there is none.
   *
   * @throws JournalDamage when it is not whole
   */
  static Optional<JournalMark> read(Path journal) throws IOException, JournalDamage {
    Path file = file(journal);
    if (!Files.exists(file)) {
      return Optional.empty();
    }
    JsonNode fields = JournalLine.read(new String(Files.readAllBytes(file), UTF_8).strip());
    return Optional.of(
        new JournalMark(generation(fields), JournalLine.number(fields), JournalLine.after(fields)));
  }

  /** As a journal's first line says; 0 when it is of a version that had no marks. */
  static int generation(JsonNode fields) {
    return fields.path(GENERATION).asInt();
  }

  static ObjectNode generation(ObjectNode fields, int generation) {
    return fields.put(GENERATION, generation);
  }

  /** Puts it in the place of the former. */
  void write(Path journal) throws IOException {
    String line =
        JournalLine.write(lines, checksum, generation(JSON.createObjectNode(), generation));
    ByteBuffer bytes =
        ByteBuffer.wrap((line + " ".repeat(BYTES - 1 - line.length()) + "\n").getBytes(UTF_8));
    try (FileChannel channel =
        FileChannel.open(file(journal), StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
      while (bytes.hasRemaining()) {
        channel.write(bytes);
      }
    }
  }
}
