package org.maestro.console.traffic;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.time.Instant;
import java.util.Base64;
import java.util.Optional;
import java.util.function.Supplier;
import org.maestro.console.documents.JsonMembers;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.MessageKind;
import org.maestro.rats.protocol.StreamFrame;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Message;

/** The documents of frames that members stream. Any thread may use it. */
public final class StreamedFrames {
  private final Topics topics;
  private final Supplier<Instant> now;
  private final WireFormat wire = new WireFormat();

  /**
   * @param now of the platform's clock
   */
  public StreamedFrames(String site, Supplier<Instant> now) {
    this.topics = new Topics(site);
    this.now = now;
  }

  /** Which member streams it; empty when it is no frame. */
  public Optional<String> streamer(Message message) {
    return topics
        .kindOf(message.topic())
        .filter(MessageKind.STREAM::equals)
        .flatMap(stream -> topics.memberOf(message.topic()));
  }

  /** Empty of a frame that nobody can read. */
  public Optional<JsonNode> document(Message message) {
    try {
      StreamFrame frame = wire.decodeFrame(message.payload());
      JsonMembers document =
          JsonMembers.empty()
              .text("member", frame.from())
              .text("feature", frame.feature())
              .text("type", frame.mediaType())
              .text("captured_at", frame.capturedAt().toString());
      document
          .node()
          .put("call", frame.id())
          .put("number", frame.number())
          .put("delay_ms", Duration.between(frame.capturedAt(), now.get()).toMillis())
          .put("data", Base64.getEncoder().encodeToString(frame.data()));
      return Optional.of(document.node());
    } catch (MalformedMessageException unreadable) {
      return Optional.empty();
    }
  }
}
