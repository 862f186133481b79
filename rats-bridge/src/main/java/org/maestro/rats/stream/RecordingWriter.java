package org.maestro.rats.stream;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import org.maestro.rats.protocol.StreamFrame;
import org.maestro.rats.protocol.WireFormat;

/**
 * Writes a stream to a file: its messages as they were on the bus, one a line, each with the time
 * of its arrival as {@code arrived}, milliseconds since 1970. One thread at a time; it waits for
 * the disk.
 */
public final class RecordingWriter implements AutoCloseable {
  private final Path file;
  private final BufferedWriter lines;
  private final WireFormat wire = new WireFormat();
  private final ObjectMapper mapper = new ObjectMapper();

  private RecordingWriter(Path file, BufferedWriter lines) {
    this.file = file;
    this.lines = lines;
  }

  /**
   * Begins a file that is not there yet: what was recorded before is not written over.
   *
   * @throws RecordingException when it is there, or cannot be written
   */
  public static RecordingWriter create(Path file) {
    try {
      return new RecordingWriter(
          file, Files.newBufferedWriter(file, UTF_8, StandardOpenOption.CREATE_NEW));
    } catch (FileAlreadyExistsException there) {
      throw new RecordingException(
          "There is a file %s already; name another, or remove it.".formatted(file), there);
    } catch (IOException failure) {
      throw failed(file, failure);
    }
  }

  /**
   * @throws RecordingException when the disk takes no more
   */
  public void add(StreamFrame frame, Instant arrivedAt) {
    try {
      ObjectNode line = (ObjectNode) mapper.readTree(wire.encode(frame));
      lines.write(mapper.writeValueAsString(line.put("arrived", arrivedAt.toEpochMilli())));
      lines.newLine();
    } catch (IOException failure) {
      throw failed(file, failure);
    }
  }

  @Override
  public void close() {
    try {
      lines.close();
    } catch (IOException failure) {
      throw failed(file, failure);
    }
  }

  private static RecordingException failed(Path file, IOException failure) {
    return new RecordingException(
        "The recording %s cannot be written (%s).".formatted(file, failure), failure);
  }
}
