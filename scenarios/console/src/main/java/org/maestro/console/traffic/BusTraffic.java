package org.maestro.console.traffic;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.console.documents.JsonMembers;
import org.maestro.rats.protocol.MessageCheck;
import org.maestro.rats.protocol.MessageKind;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Transport;

/**
 * The latest messages of a site's bus but for streams, heard by a client of its own that listens to
 * all topics and says nothing. They are kept as they came; what they are is found when somebody
 * looks.
 */
public final class BusTraffic implements Source, AutoCloseable {
  private static final int MOST_MESSAGES = 1_000;
  private static final long MOST_BYTES = 8_000_000;
  private static final int MOST_CHARACTERS = 4_000;

  private final Transport transport;
  private final Topics topics;
  private final String all;
  private final Supplier<Duration> now;
  private final Consumer<Message> also;
  private final MessageCheck check;
  private final BusMessageDocument documents;
  private final Ring<BusMessage> ring = new Ring<>(MOST_MESSAGES, MOST_BYTES);
  private volatile boolean listening;

  /**
   * @param transport not open yet; closed with this
   * @param now simulated time since the platform's clock began
   * @param also is told each message as it comes
   */
  public BusTraffic(
      Transport transport, String site, Supplier<Duration> now, Consumer<Message> also) {
    this.transport = transport;
    this.now = now;
    this.also = also;
    this.topics = new Topics(site);
    this.all = topics.everything();
    this.check = new MessageCheck(topics);
    this.documents = new BusMessageDocument(topics);
  }

  /** Begins with what the broker has kept. */
  public void listen() {
    transport.subscribe(all, Transport.RetainedMessages.SEND, this::arrived);
    transport.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            listening(true);
          }

          @Override
          public void lost(String reason) {
            listening(false);
          }
        });
  }

  private void listening(boolean does) {
    listening = does;
    ring.pass();
  }

  /** What rooms look and sound like is not kept, and would push out all else. */
  private void arrived(Message message) {
    if (topics.kindOf(message.topic()).filter(MessageKind.STREAM::equals).isEmpty()) {
      keep(message);
    }
    also.accept(message);
  }

  private void keep(Message message) {
    byte[] payload = message.payload();
    boolean fits = payload.length <= WireFormat.MOST_BYTES;
    ring.add(
        new BusMessage(
            message.topic(),
            fits ? payload : Arrays.copyOf(payload, MOST_CHARACTERS),
            payload.length,
            message.retained(),
            fits ? Optional.empty() : check.fault(message.topic(), payload, message.retained()),
            Instant.now(),
            now.get()),
        fits ? payload.length : MOST_CHARACTERS);
  }

  @Override
  public long latest() {
    return ring.latest();
  }

  @Override
  public JsonNode between(long after, long last) {
    JsonMembers document = JsonMembers.empty().truth("listening", listening);
    ArrayNode messages = document.node().putArray("messages");
    ring.between(after, last).forEach(kept -> messages.add(documents.of(kept, MOST_CHARACTERS)));
    return document.node();
  }

  /** One message with all of its payload; empty when it is not kept any more. */
  public Optional<JsonNode> message(long number) {
    return ring.find(number).map(kept -> documents.of(kept, Integer.MAX_VALUE));
  }

  @Override
  public void close() {
    transport.close();
  }
}
