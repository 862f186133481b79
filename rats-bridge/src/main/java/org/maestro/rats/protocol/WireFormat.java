package org.maestro.rats.protocol;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The JSON of version 1, as the JSON Schemas beside it describe it. Unknown fields are ignored, an
 * unknown error code counts as INTERNAL and an unknown kind of progress as RUNNING, since later
 * minor versions may add some; an unknown major version is refused. Equal messages have equal
 * bytes, whatever maps they hold. Safe for use by several threads.
 *
 * <p>Decoding throws {@link MalformedMessageException}, encoding IllegalArgumentException for
 * values that JSON cannot hold.
 */
public final class WireFormat {

  /** What this codec writes: major, that the topic names too, and minor. */
  public static final String VERSION = "1.4";

  /** The longest payload that is read, in bytes. */
  public static final int MOST_BYTES = 256 * 1024;

  /** How deep objects and lists may be nested. */
  public static final int MOST_NESTING = 16;

  /** Of an error's text, which may quote anything; receivers take somewhat more. */
  private static final int MOST_SAID = 8_000;

  /** Of a text in a fault of a description. */
  private static final int MOST_QUOTED = 1_000;

  private static final long LONGEST_TIMEOUT_MILLIS = Duration.ofDays(7).toMillis();

  /** The end of the year 9999. */
  private static final long LATEST_MILLIS = 253_402_300_799_999L;

  private static final Logger LOG = LoggerFactory.getLogger(WireFormat.class);

  /** For a look at a call that is read in full if it concerns the reader. */
  private static final JsonFactory GLANCES =
      JsonFactory.builder()
          .streamReadConstraints(
              StreamReadConstraints.builder().maxNestingDepth(MOST_NESTING).build())
          .build();

  /** One for all, as it is large, and never changes. */
  private static final JsonMapper MAPPER =
      JsonMapper.builder(
              JsonFactory.builder()
                  .streamReadConstraints(
                      StreamReadConstraints.builder().maxNestingDepth(MOST_NESTING).build())
                  .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
                  // Some languages write what is no number so; a field that holds it is named.
                  .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
                  .build())
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .enable(SerializationFeature.ORDER_MAP_ENTRIES_BY_KEYS)
          .build();

  public byte[] encode(Call call) {
    return bytes(fields(call));
  }

  private static Map<String, Object> fields(Call call) {
    Map<String, Object> fields = message(call.id());
    call.member().ifPresent(member -> fields.put("r", member));
    call.boot().ifPresent(boot -> fields.put("boot", boot));
    fields.put("f", call.feature());
    fields.put("p", call.parameters());
    fields.put("t", Math.max(1, call.timeout().toMillis()));
    fields.put("from", call.from());
    call.task().ifPresent(task -> fields.put("task", task));
    call.expects().ifPresent(expected -> fields.put("expects", expectation(expected)));
    call.sent().ifPresent(sent -> fields.put("sent", sent(sent)));
    return fields;
  }

  /**
   * @throws IllegalArgumentException when the call holds what JSON cannot, or too much
   */
  public void require(Call call) {
    bytes(fields(call));
  }

  public Call decodeCall(byte[] payload) {
    Fields fields = fields(payload);
    return new Call(
        fields.text("id", Rule.ID),
        fields.optionalText("r", Rule.TEXT).filter(member -> !member.isEmpty()),
        fields.optionalText("boot", Rule.ID),
        fields.text("f", Rule.FEATURE),
        fields.values("p"),
        Duration.ofMillis(fields.integer("t", 1, LONGEST_TIMEOUT_MILLIS)),
        fields.text("from", Rule.NAME),
        fields.optionalText("task", Rule.TEXT),
        fields.has("expects")
            ? Optional.of(expectation(fields.object("expects")))
            : Optional.empty(),
        fields.has("sent") ? Optional.of(sent(fields.object("sent"))) : Optional.empty());
  }

  private static Map<String, Object> sent(Call.Sent sent) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("clock", sent.clock());
    fields.put("ms", sent.millis());
    return fields;
  }

  private static Call.Sent sent(Fields fields) {
    return new Call.Sent(fields.text("clock", Rule.ID), fields.integer("ms", 0, Long.MAX_VALUE));
  }

  private static Map<String, Object> expectation(Call.Expectation expected) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("cost", expected.cost());
    fields.put("seconds", expected.seconds());
    return fields;
  }

  private static Call.Expectation expectation(Fields fields) {
    return new Call.Expectation(fields.amount("cost"), fields.amount("seconds"));
  }

  /**
   * To whom a call is addressed that may be malformed otherwise; empty when not even that can be
   * read.
   */
  public Optional<CallAddress> addressOf(byte[] payload) {
    Map<String, String> texts = textsUntilItBreaks(payload);
    return Optional.ofNullable(texts.get("r"))
        .filter(Rule.NAME::allows)
        .flatMap(member -> id(texts).map(id -> new CallAddress(id, member)));
  }

  /** The id of a message that may be malformed otherwise; empty when not even that can be read. */
  public Optional<String> idOf(byte[] payload) {
    return id(textsUntilItBreaks(payload));
  }

  private static Optional<String> id(Map<String, String> texts) {
    return Optional.ofNullable(texts.get("id")).filter(Rule.ID::allows);
  }

  /** The fields of a message that are texts, up to where it cannot be read; whole ones only. */
  private static Map<String, String> textsUntilItBreaks(byte[] payload) {
    Map<String, String> texts = new LinkedHashMap<>();
    if (payload.length > MOST_BYTES) {
      return texts;
    }
    try (JsonParser parser = GLANCES.createParser(new String(payload, UTF_8))) {
      if (parser.nextToken() != JsonToken.START_OBJECT) {
        return texts;
      }
      while (parser.nextToken() == JsonToken.FIELD_NAME) {
        String field = parser.currentName();
        if (parser.nextToken() == JsonToken.VALUE_STRING) {
          texts.putIfAbsent(field, WholeText.mended(parser.getText()));
        }
        parser.skipChildren();
      }
    } catch (IOException broken) {
      LOG.trace("A message cannot be read to its end: {}", broken.getMessage());
    }
    return texts;
  }

  /**
   * Whether a call names another receiver than this one. Looks no further than it must, as
   * everybody hears all calls; false when it cannot tell.
   */
  public boolean isForAnother(byte[] call, String member) {
    if (call.length > MOST_BYTES) {
      return false;
    }
    try (JsonParser parser = GLANCES.createParser(call)) {
      if (parser.nextToken() != JsonToken.START_OBJECT) {
        return false;
      }
      while (parser.nextToken() == JsonToken.FIELD_NAME) {
        boolean receiver = parser.currentName().equals("r");
        JsonToken value = parser.nextToken();
        if (receiver) {
          return value == JsonToken.VALUE_STRING
              && !parser.getText().isEmpty()
              && !parser.getText().equals(member);
        }
        parser.skipChildren();
      }
      return false;
    } catch (IOException unreadable) {
      return false;
    }
  }

  public byte[] encode(Result result) {
    Map<String, Object> fields = message(result.id());
    fields.put("from", result.from());
    fields.put("outcome", result.outcome().name());
    fields.put("z", result.state());
    fields.put("values", result.values());
    result.error().ifPresent(error -> fields.put("error", error(error)));
    return bytes(fields);
  }

  public Result decodeResult(byte[] payload) {
    Fields fields = fields(payload);
    Outcome outcome = fields.constant("outcome", Outcome.class);
    Optional<RatsError> error =
        fields.has("error") || outcome != Outcome.SUCCEEDED
            ? Optional.of(error(fields.object("error")))
            : Optional.empty();
    return new Result(
        fields.text("id", Rule.ID),
        fields.text("from", Rule.NAME),
        outcome,
        fields.text("z", Rule.TEXT),
        fields.told("values"),
        error);
  }

  public byte[] encode(Progress progress) {
    Map<String, Object> fields = message(progress.id());
    fields.put("from", progress.from());
    fields.put("kind", progress.kind().name());
    fields.put("fraction", progress.fraction());
    fields.put("values", progress.values());
    return bytes(fields);
  }

  public Progress decodeProgress(byte[] payload) {
    Fields fields = fields(payload);
    return new Progress(
        fields.text("id", Rule.ID),
        fields.text("from", Rule.NAME),
        fields.constantOr(Progress.Kind.RUNNING, "kind", Rule.WORD),
        fields.fraction("fraction"),
        fields.told("values"));
  }

  public byte[] encode(Observation observation) {
    Map<String, Object> fields = message(observation.id());
    fields.put("from", observation.from());
    fields.put("f", observation.feature());
    fields.put("values", observation.values());
    return bytes(fields);
  }

  public Observation decodeObservation(byte[] payload) {
    Fields fields = fields(payload);
    return new Observation(
        fields.text("id", Rule.ID),
        fields.text("from", Rule.NAME),
        fields.text("f", Rule.FEATURE),
        fields.told("values"));
  }

  /**
   * @throws IllegalArgumentException also for more data than a message holds
   */
  public byte[] encode(StreamFrame frame) {
    if (frame.data().length > StreamFrame.MOST_BYTES) {
      throw new IllegalArgumentException(
          "A frame of %d bytes is more than the %d that a message holds"
              .formatted(frame.data().length, StreamFrame.MOST_BYTES));
    }
    Map<String, Object> fields = message(frame.id());
    fields.put("from", frame.from());
    fields.put("f", frame.feature());
    fields.put("n", frame.number());
    fields.put("at", frame.capturedAt().toEpochMilli());
    fields.put("type", frame.mediaType());
    fields.put("data", Base64.getEncoder().encodeToString(frame.data()));
    return bytes(fields);
  }

  public StreamFrame decodeFrame(byte[] payload) {
    Fields fields = fields(payload);
    return new StreamFrame(
        fields.text("id", Rule.ID),
        fields.text("from", Rule.NAME),
        fields.text("f", Rule.FEATURE),
        fields.integer("n", 1, Long.MAX_VALUE),
        Instant.ofEpochMilli(fields.integer("at", 0, LATEST_MILLIS)),
        fields.text("type", Rule.MEDIA_TYPE),
        fields.bytes("data"));
  }

  /** Of a member or of a controller. */
  public byte[] encode(MemberStatus status) {
    Map<String, Object> fields = message(status.member());
    fields.put("status", status.phase().name().toLowerCase(Locale.ROOT));
    fields.put("boot", status.boot());
    return bytes(fields);
  }

  public MemberStatus decodeStatus(byte[] payload) {
    Fields fields = fields(payload);
    return new MemberStatus(
        fields.text("id", Rule.NAME),
        fields.lowerCaseConstant("status", MemberStatus.Phase.class),
        fields.text("boot", Rule.ID));
  }

  public byte[] encode(MemberState state) {
    Map<String, Object> fields = message(state.member());
    fields.put("boot", state.boot());
    fields.put("z", state.state());
    fields.put("values", state.values());
    fields.put("running", state.running());
    fields.put("queue", state.queue());
    fields.put("disabled", state.disabled());
    if (!state.recent().isEmpty()) {
      fields.put("recent", state.recent().stream().map(WireFormat::ended).toList());
    }
    return bytes(fields);
  }

  public MemberState decodeState(byte[] payload) {
    Fields fields = fields(payload);
    return new MemberState(
        fields.text("id", Rule.NAME),
        fields.text("boot", Rule.ID),
        fields.text("z", Rule.TEXT),
        fields.texts("values", Rule.TEXT),
        fields.texts("running", Rule.ID),
        fields.texts("queue", Rule.ID),
        fields.texts("disabled", Rule.FEATURE),
        fields.objects("recent").stream().map(WireFormat::ended).toList());
  }

  /** With as many faults as a message holds. */
  public byte[] encode(Verdict verdict) {
    List<Verdict.Fault> faults = verdict.faults();
    while (true) {
      Map<String, Object> fields = message(verdict.member());
      fields.put("boot", verdict.boot());
      fields.put("accepted", verdict.accepted());
      fields.put("faults", faults.stream().map(WireFormat::fault).toList());
      try {
        return bytes(fields);
      } catch (IllegalArgumentException tooMuch) {
        if (faults.isEmpty()) {
          throw tooMuch;
        }
        faults = faults.subList(0, faults.size() / 2);
      }
    }
  }

  public Verdict decodeVerdict(byte[] payload) {
    Fields fields = fields(payload);
    return new Verdict(
        fields.text("id", Rule.NAME),
        fields.text("boot", Rule.ID),
        fields.truth("accepted"),
        fields.objects("faults").stream().map(WireFormat::fault).toList());
  }

  private static Map<String, Object> fault(Verdict.Fault fault) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("line", fault.line());
    fields.put("subject", shortened(fault.subject()));
    fields.put("property", shortened(fault.property()));
    fields.put("problem", shortened(fault.problem()));
    fields.put("cure", shortened(fault.cure()));
    return fields;
  }

  /** What a description says wrongly may be quoted, however long and odd it is. */
  private static String shortened(String text) {
    StringBuilder whole = new StringBuilder();
    text.codePoints()
        .limit(MOST_QUOTED)
        .map(c -> Character.getType(c) == Character.SURROGATE ? '?' : c)
        .forEach(whole::appendCodePoint);
    return text.codePointCount(0, text.length()) <= MOST_QUOTED ? whole.toString() : whole + "...";
  }

  private static Verdict.Fault fault(Fields fields) {
    return new Verdict.Fault(
        (int) fields.integer("line", 0, Integer.MAX_VALUE),
        fields.text("subject", Rule.TEXT),
        fields.text("property", Rule.TEXT),
        fields.text("problem", Rule.TEXT),
        fields.text("cure", Rule.TEXT));
  }

  private static Map<String, Object> ended(MemberState.Ended ended) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("id", ended.id());
    fields.put("outcome", ended.outcome().name());
    return fields;
  }

  private static MemberState.Ended ended(Fields fields) {
    return new MemberState.Ended(
        fields.text("id", Rule.ID), fields.constant("outcome", Outcome.class));
  }

  private static Map<String, Object> error(RatsError error) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("code", error.code().name());
    fields.put("level", error.level().name());
    fields.put("message", WholeText.shortened(error.message(), MOST_SAID));
    error.hint().ifPresent(hint -> fields.put("hint", WholeText.shortened(hint, MOST_SAID)));
    List<Map<String, Object>> refs = error.refs().stream().map(WireFormat::reference).toList();
    fields.put("refs", refs);
    fields.put("retriable", error.retriable());
    return fields;
  }

  private static Map<String, Object> reference(RatsError.Reference reference) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("fact", reference.fact());
    fields.put("need", reference.need());
    fields.put("have", reference.have());
    return fields;
  }

  private static RatsError error(Fields fields) {
    return new RatsError(
        fields.constantOr(ErrorCode.INTERNAL, "code", Rule.WORD),
        fields.constant("level", RatsError.Level.class),
        fields.text("message", Rule.TEXT),
        fields.optionalText("hint", Rule.TEXT),
        fields.objects("refs").stream()
            .map(
                reference ->
                    new RatsError.Reference(
                        reference.text("fact", Rule.TEXT),
                        reference.text("need", Rule.TEXT),
                        reference.scalar("have")))
            .toList(),
        fields.truth("retriable"));
  }

  private static Map<String, Object> message(String id) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("v", VERSION);
    fields.put("id", id);
    return fields;
  }

  private byte[] bytes(Map<String, Object> fields) {
    JsonValues.require(fields);
    try {
      byte[] bytes = MAPPER.writeValueAsBytes(fields);
      if (bytes.length > MOST_BYTES) {
        throw new IllegalArgumentException(
            "The message %s has %d bytes, and nobody reads more than %d"
                .formatted(fields.get("id"), bytes.length, MOST_BYTES));
      }
      return bytes;
    } catch (JsonProcessingException unwritable) {
      throw new IllegalArgumentException(
          "The message " + fields.get("id") + " cannot be written as JSON", unwritable);
    }
  }

  /** Of any message: longer ones are not read. */
  void requireReadable(byte[] payload) {
    if (payload.length > MOST_BYTES) {
      throw new MalformedMessageException(
          "payload", "at most " + MOST_BYTES + " bytes", payload.length + " bytes");
    }
  }

  private Fields fields(byte[] payload) {
    requireReadable(payload);
    JsonNode root;
    try {
      root = MAPPER.readTree(payload);
    } catch (IOException unreadable) {
      throw new MalformedMessageException(
          "payload",
          "one JSON object nested at most " + MOST_NESTING + " deep",
          "not: " + firstLine(unreadable));
    }
    if (root == null || !root.isObject()) {
      throw new MalformedMessageException("payload", "one JSON object", "something else");
    }
    requireVersion(root);
    return new Fields(root, "");
  }

  private static void requireVersion(JsonNode root) {
    String version = new Fields(root, "").text("v", Rule.VERSION);
    if (!version.startsWith("1.")) {
      throw new MalformedMessageException(
          ErrorCode.UNSUPPORTED_VERSION, "v", "of major version 1", version);
    }
  }

  private static String firstLine(IOException unreadable) {
    return unreadable instanceof JsonProcessingException json
        ? json.getOriginalMessage()
        : Objects.requireNonNullElse(unreadable.getMessage(), unreadable.toString());
  }
}
