package org.maestro.rats.protocol;

import java.util.Optional;

/**
 * The check of a message by who listens to a whole site and takes part in nothing: whether it is as
 * the documents of version 1 say. What a description says of its device is not judged. Safe for use
 * by several threads.
 */
public final class MessageCheck {
  private final Topics topics;
  private final WireFormat wire = new WireFormat();

  public MessageCheck(Topics topics) {
    this.topics = topics;
  }

  /**
   * Why those whom it is for pass it over; empty when they do not.
   *
   * @param retained whether it has the retain flag
   * @return a clause, without a full stop
   */
  public Optional<String> fault(String topic, byte[] payload, boolean retained) {
    Optional<MessageKind> kind = topics.kindOf(topic);
    if (kind.isEmpty()) {
      return Optional.of("No message of the bus has the topic " + topic);
    }
    if (kind.get() == MessageKind.CALL && retained) {
      return Optional.of("A call must not be retained; nobody executes it");
    }
    if (payload.length == 0 && kind.get().isRetained()) {
      return Optional.empty();
    }
    return faultOf(kind.get(), topic, payload);
  }

  private Optional<String> faultOf(MessageKind kind, String topic, byte[] payload) {
    try {
      Optional<String> sender = sender(kind, payload);
      String speaker = topics.speakerOf(topic);
      return sender
          .filter(named -> !speaker.equals(topic) && !speaker.equals(named))
          .map(named -> "A message of %s on the topic %s is ignored".formatted(named, topic));
    } catch (MalformedMessageException malformed) {
      return Optional.of(String.valueOf(malformed.getMessage()));
    }
  }

  /** Reads it, and says by whom it says that it is; empty where it does not say. */
  private Optional<String> sender(MessageKind kind, byte[] payload) {
    return switch (kind) {
      case CALL -> Optional.of(wire.decodeCall(payload).from());
      case RESULT -> Optional.of(wire.decodeResult(payload).from());
      case PROGRESS -> Optional.of(wire.decodeProgress(payload).from());
      case STATUS -> Optional.of(wire.decodeStatus(payload).member());
      case STATE -> Optional.of(wire.decodeState(payload).member());
      case OBSERVATION -> Optional.of(wire.decodeObservation(payload).from());
      case STREAM -> Optional.of(wire.decodeFrame(payload).from());
      case VERDICT -> {
        wire.decodeVerdict(payload);
        yield Optional.empty();
      }
      case DESCRIPTION -> {
        wire.requireReadable(payload);
        yield Optional.empty();
      }
    };
  }
}
