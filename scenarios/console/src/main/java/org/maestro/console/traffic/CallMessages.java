package org.maestro.console.traffic;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.MessageKind;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Message;

/** The messages of one site's bus that belong to a call: what they say, of which call. */
public final class CallMessages {
  private static final int PERCENT = 100;

  private final Topics topics;
  private final WireFormat wire = new WireFormat();

  public CallMessages(String site) {
    this.topics = new Topics(site);
  }

  /**
   * What such a message says.
   *
   * @param call its id
   * @param about the call that is meant: another one, where a call ends it
   * @param goal that the call itself names
   * @param isOneOfMany whether others of its kind follow
   */
  public record Said(
      String kind,
      String call,
      String about,
      Optional<String> goal,
      String from,
      Optional<String> to,
      String text,
      boolean isOneOfMany) {}

  /** Empty for all that belongs to no call, or is not understood. */
  public Optional<Said> read(Message message) {
    if (message.payload().length > WireFormat.MOST_BYTES) {
      return Optional.empty();
    }
    try {
      return topics.kindOf(message.topic()).flatMap(kind -> read(kind, message));
    } catch (MalformedMessageException e) {
      return Optional.empty();
    }
  }

  private Optional<Said> read(MessageKind kind, Message message) {
    String word = kind.name().toLowerCase(Locale.ROOT);
    Optional<String> receiver = topics.receiverOf(message.topic());
    return switch (kind) {
      case CALL -> Optional.of(call(word, wire.decodeCall(message.payload())));
      case RESULT -> {
        Result result = wire.decodeResult(message.payload());
        String text =
            result.outcome()
                + " "
                + result.error().map(error -> error.message()).orElse(values(result.values()));
        yield Optional.of(said(word, result.id(), result.from(), receiver, text, false));
      }
      case PROGRESS -> {
        Progress progress = wire.decodeProgress(message.payload());
        String text =
            "%s %.0f %%".formatted(progress.kind(), progress.fraction() * PERCENT)
                + values(progress.values());
        yield Optional.of(said(word, progress.id(), progress.from(), receiver, text, true));
      }
      case OBSERVATION -> {
        Observation seen = wire.decodeObservation(message.payload());
        yield Optional.of(
            said(word, seen.id(), seen.from(), Optional.empty(), values(seen.values()), true));
      }
      case STATUS, DESCRIPTION, STATE, STREAM, VERDICT -> Optional.empty();
    };
  }

  private static Said call(String word, Call call) {
    String about =
        call.feature().equals(ReservedFeature.CANCEL.word())
            ? String.valueOf(call.parameters().get("id"))
            : call.id();
    return new Said(
        word,
        call.id(),
        about,
        call.task(),
        call.from(),
        call.member(),
        call.feature() + " " + values(call.parameters()),
        false);
  }

  /** In the order of their names, as a person reads them. */
  private static String values(Map<String, Object> values) {
    return values.isEmpty() ? "" : new TreeMap<>(values).toString();
  }

  private static Said said(
      String kind,
      String call,
      String from,
      Optional<String> to,
      String text,
      boolean isOneOfMany) {
    return new Said(kind, call, call, Optional.empty(), from, to, text, isOneOfMany);
  }
}
