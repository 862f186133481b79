package org.maestro.console.traffic;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.documents.ShownText;
import org.maestro.rats.protocol.CallAddress;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.protocol.MessageCheck;
import org.maestro.rats.protocol.MessageKind;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.text.VisibleText;

/** The documents of messages of one site's bus: what they are, and what is wrong with them. */
final class BusMessageDocument {
  private final Topics topics;
  private final MessageCheck check;
  private final WireFormat wire = new WireFormat();

  BusMessageDocument(Topics topics) {
    this.topics = topics;
    this.check = new MessageCheck(topics);
  }

  /**
   * @param most characters of the payload
   */
  ObjectNode of(Ring.Kept<BusMessage> kept, int most) {
    BusMessage message = kept.what();
    Optional<MessageKind> kind = topics.kindOf(message.topic());
    JsonMembers row =
        JsonMembers.empty()
            .text("topic", VisibleText.line(message.topic()))
            .text("kind", kind.map(known -> known.name().toLowerCase(Locale.ROOT)))
            .text("from", kind.flatMap(known -> sender(message.topic())))
            .text("to", receiver(kind, message))
            .truth("retained", message.retained())
            .number("bytes", OptionalInt.of(message.bytes()));
    ShownText.add(row, "payload", new String(message.payload(), UTF_8), most);
    row.text("at", message.at().toString())
        .number("at_s", message.since().toMillis() / 1000.0)
        .text("problem", problem(message).map(BusMessageDocument::sentence));
    row.node().put("number", kept.number());
    return row.node();
  }

  private Optional<String> sender(String topic) {
    return Optional.of(topics.speakerOf(topic)).filter(speaker -> !speaker.equals(topic));
  }

  private Optional<String> receiver(Optional<MessageKind> kind, BusMessage message) {
    if (kind.filter(MessageKind.CALL::equals).isPresent()) {
      return wire.addressOf(message.payload()).map(CallAddress::member);
    }
    return topics.receiverOf(message.topic());
  }

  Optional<String> problem(BusMessage message) {
    return message
        .problem()
        .or(() -> check.fault(message.topic(), message.payload(), message.retained()));
  }

  /** What quotes a message may quote anything. */
  private static String sentence(String problem) {
    String shown = ShownText.of(Complaints.shortened(problem));
    return shown.endsWith(".") ? shown : shown + ".";
  }
}
