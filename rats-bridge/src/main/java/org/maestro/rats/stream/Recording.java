package org.maestro.rats.stream;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.StreamFrame;
import org.maestro.rats.protocol.WireFormat;

/**
 * A stream that was recorded, in the order of its capture.
 *
 * @param frames one at least
 */
public record Recording(List<StreamFrame> frames) {
  private static final long MOST_BYTES = 256L * 1024 * 1024;

  public Recording {
    frames = List.copyOf(frames);
  }

  /**
   * Reads what {@link RecordingWriter} has written. It waits for the disk.
   *
   * @throws RecordingException when it cannot be read, is longer than 256 MiB, or holds something
   *     else than frames, with the line
   */
  public static Recording read(Path file) {
    List<StreamFrame> frames = new ArrayList<>();
    WireFormat wire = new WireFormat();
    try {
      if (Files.size(file) > MOST_BYTES) {
        throw new RecordingException(
            "The recording %s has more than 256 MiB; split it at the end of a line."
                .formatted(file));
      }
      for (String line : Files.readAllLines(file, UTF_8)) {
        StreamFrame frame = wire.decodeFrame(line.getBytes(UTF_8));
        if (!frames.isEmpty()
            && frame.capturedAt().isBefore(frames.get(frames.size() - 1).capturedAt())) {
          throw new RecordingException(
              "Line %d of the recording %s was captured before the line above it; play one recording at a time."
                  .formatted(frames.size() + 1, file));
        }
        frames.add(frame);
      }
    } catch (MalformedMessageException malformed) {
      throw new RecordingException(
          "Line %d of the recording %s is no frame of a stream: %s."
              .formatted(frames.size() + 1, file, malformed.getMessage()),
          malformed);
    } catch (IOException failure) {
      throw new RecordingException(
          "The recording %s cannot be read (%s).".formatted(file, failure), failure);
    }
    if (frames.isEmpty()) {
      throw new RecordingException("The recording %s is empty.".formatted(file));
    }
    return new Recording(frames);
  }

  /** From the first frame's capture to that one's. */
  Duration offset(int frame) {
    return Duration.between(frames.get(0).capturedAt(), frames.get(frame).capturedAt());
  }
}
