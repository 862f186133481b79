package org.maestro.rats.protocol;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.time.Duration;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WireFormatTest {

  private static final String CALL =
      "{\"v\":\"1.0\",\"id\":\"c1\",\"r\":\"rose\",\"f\":\"pick\",\"p\":{},\"t\":5,\"from\":\"cca\"}";

  private final WireFormat wire = new WireFormat();
  private final Schemas schemas = new Schemas();

  @Test
  void callsPassTheSchemaAndComeBack() throws IOException {
    Map<String, Object> pointer = new LinkedHashMap<>();
    pointer.put("ref", "urn:home:arena#GreenObject");
    pointer.put("position", List.of(2.1, 0.4, 0.1));
    Map<String, Object> parameters = new LinkedHashMap<>();
    parameters.put("level", 0.5);
    parameters.put("gentle", true);
    parameters.put("object", pointer);
    Call call =
        new Call(
            "cca-7-1",
            Optional.of("rose"),
            Optional.of("7f3"),
            "pick",
            parameters,
            Duration.ofSeconds(15),
            "cca",
            Optional.of("G12"));
    schemas.assertValid("call", wire.encode(call));
    assertThat(wire.decodeCall(wire.encode(call))).isEqualTo(call);
    Call bare =
        new Call(
            "1",
            Optional.empty(),
            Optional.empty(),
            "$safe",
            Map.of(),
            Duration.ofMillis(1),
            "cca",
            Optional.empty());
    schemas.assertValid("call", wire.encode(bare));
    assertThat(wire.decodeCall(wire.encode(bare))).isEqualTo(bare);
  }

  @Test
  void resultsPassTheSchemaAndComeBack() throws IOException {
    RatsError error =
        new RatsError(
            ErrorCode.PRECONDITION_NOT_MET,
            RatsError.Level.WARNING,
            "16 lux in zone-b, 72 needed",
            Optional.of("raise the light in zone-b"),
            List.of(new RatsError.Reference("(illuminance zone-b)", ">= 72", 16)),
            true);
    for (Outcome outcome : Outcome.values()) {
      Optional<RatsError> cause =
          outcome == Outcome.SUCCEEDED ? Optional.empty() : Optional.of(error);
      Result result = new Result("c1", "cam-b", outcome, "standby", Map.of("lux", 16.5), cause);
      schemas.assertValid("result", wire.encode(result));
      assertThat(wire.decodeResult(wire.encode(result))).isEqualTo(result);
    }
  }

  @Test
  void everyErrorCodeIsInTheSchema() throws IOException {
    for (ErrorCode code : ErrorCode.values()) {
      RatsError error =
          new RatsError(code, RatsError.Level.ERROR, "why", Optional.empty(), List.of(), false);
      schemas.assertValid(
          "result",
          wire.encode(
              new Result("c1", "rose", Outcome.FAILED, "busy", Map.of(), Optional.of(error))));
    }
    assertThat(Schemas.document("common.json").at("/$defs/error/properties/code/anyOf/0/enum"))
        .hasSize(ErrorCode.values().length);
  }

  @Test
  void progressObservationsStatusAndStatePassTheirSchemas() throws IOException {
    for (Progress.Kind kind : Progress.Kind.values()) {
      Progress progress = new Progress("c1", "rose", kind, 0.25, Map.of("found", true));
      schemas.assertValid("progress", wire.encode(progress));
      assertThat(wire.decodeProgress(wire.encode(progress))).isEqualTo(progress);
    }
    Observation observation = new Observation("c1", "lux-a", "measure", Map.of("lux", 16.5));
    schemas.assertValid("observation", wire.encode(observation));
    assertThat(wire.decodeObservation(wire.encode(observation))).isEqualTo(observation);
    for (MemberStatus.Phase phase : MemberStatus.Phase.values()) {
      MemberStatus status = new MemberStatus("rose", phase, "7f3");
      schemas.assertValid("status", wire.encode(status));
      assertThat(wire.decodeStatus(wire.encode(status))).isEqualTo(status);
    }
    MemberState state =
        new MemberState(
            "rose",
            "7f3",
            "busy",
            List.of("(in Cup rose)"),
            List.of("c1"),
            List.of("c2"),
            List.of("pick"));
    schemas.assertValid("state", wire.encode(state));
    assertThat(wire.decodeState(wire.encode(state))).isEqualTo(state);
  }

  @Property(tries = 100)
  void anyValuesComeBack(
      @ForAll @Size(max = 5) Map<String, Double> numbers,
      @ForAll @Size(max = 5) List<String> texts,
      @ForAll long whole,
      @ForAll @IntRange(min = 1) int millis) {
    Map<String, Object> parameters = new LinkedHashMap<>();
    parameters.put("numbers", numbers);
    parameters.put("texts", texts);
    parameters.put("whole", whole > Integer.MAX_VALUE ? (Object) whole : (Object) (int) whole);
    Call call =
        new Call(
            "c",
            Optional.empty(),
            Optional.empty(),
            "f",
            parameters,
            Duration.ofMillis(Math.min(millis, 604_800_000)),
            "cca",
            Optional.empty());
    assertThat(wire.decodeCall(wire.encode(call))).isEqualTo(call);
  }

  @Test
  void equalMessagesHaveEqualBytes() {
    Map<String, Object> one = new LinkedHashMap<>();
    one.put("b", 1);
    one.put("a", 2);
    assertThat(wire.encode(new Observation("c", "rose", "f", one)))
        .isEqualTo(wire.encode(new Observation("c", "rose", "f", new HashMap<>(one))));
  }

  @Test
  void ignoresUnknownFieldsAndLaterMinorVersions() {
    String later =
        CALL.replace("\"1.0\"", "\"1.7\"").replace("\"p\":{}", "\"p\":{},\"new\":[null]");
    assertThat(wire.decodeCall(later.getBytes(UTF_8)).feature()).isEqualTo("pick");
  }

  @Test
  void readsWordsThatALaterMinorVersionMayAdd() throws IOException {
    byte[] result =
        """
        {"v":"1.4","id":"c","from":"rose","outcome":"FAILED","z":"x",
         "error":{"code":"TOO_TIRED","level":"ERROR","message":"why","retriable":false}}"""
            .getBytes(UTF_8);
    schemas.assertValid("result", result);
    assertThat(wire.decodeResult(result).error().orElseThrow().code())
        .isEqualTo(ErrorCode.INTERNAL);
    byte[] progress =
        """
        {"v":"1.4","id":"c","from":"rose","kind":"HALF_WAY","fraction":0.5}"""
            .getBytes(UTF_8);
    schemas.assertValid("progress", progress);
    assertThat(wire.decodeProgress(progress).kind()).isEqualTo(Progress.Kind.RUNNING);
    byte[] lowerCase = new String(progress, UTF_8).replace("HALF_WAY", "half way").getBytes(UTF_8);
    assertThatThrownBy(() -> wire.decodeProgress(lowerCase))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("kind");
    assertThat(schemas.faults("progress", lowerCase)).isNotEmpty();
  }

  @Test
  void takesAnEmptyReceiverAsBlank() {
    assertThat(wire.decodeCall(CALL.replace("rose", "").getBytes(UTF_8)).member()).isEmpty();
  }

  @Test
  void refusesAnotherMajorVersion() {
    MalformedMessageException refusal = refusal(CALL.replace("\"1.0\"", "\"2.0\""));
    assertThat(refusal.code()).isEqualTo(ErrorCode.UNSUPPORTED_VERSION);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "\"t\":5|\"t\":0|t",
        "\"t\":5|\"t\":5.5|t",
        "\"t\":5|\"t\":\"5\"|t",
        "\"t\":5,|'' |t",
        "\"id\":\"c1\"|\"id\":\"\"|id",
        "\"id\":\"c1\"|\"id\":7|id",
        "cca|a/b|from",
        "cca|+|from",
        "pick|pi ck|f",
        "pick|a/#|f",
        "{}|[]|p",
        "{}|{\"a\":null}|p.a",
        "{}|{\"a\":[1,null]}|p.a[1]",
        "{}|{\"a\":1e999}|p.a",
        "{}|{\"a\":1,\"a\":2}|payload",
        "\"v\":\"1.0\",|''|v",
        "\"1.0\"|\"one\"|v",
        "\"1.0\"|1.0|v",
        "\"cca\"}|\"cca\"}x|payload"
      })
  void namesTheFieldAndTheRule(String part, String replacement, String field) {
    MalformedMessageException refusal = refusal(CALL.replace(part, replacement.strip()));
    assertThat(refusal.field()).isEqualTo(field);
    assertThat(refusal).hasMessageContaining(field).hasMessageContaining("must be");
  }

  @Test
  void refusesWhatIsTooBigOrTooDeep() {
    String deep = CALL.replace("{}", "{\"a\":" + "[".repeat(20) + "]".repeat(20) + "}");
    assertThat(refusal(deep).field()).isEqualTo("payload");
    String big = CALL.replace("{}", "{\"a\":\"" + "x".repeat(WireFormat.MOST_BYTES) + "\"}");
    assertThat(refusal(big)).hasMessageContaining("bytes");
    assertThat(refusal("").field()).isEqualTo("payload");
    assertThat(refusal("[1]").field()).isEqualTo("payload");
  }

  @Test
  void asksForAnErrorUnlessSucceeded() throws IOException {
    String failed =
        "{\"v\":\"1.0\",\"id\":\"c\",\"from\":\"rose\",\"outcome\":\"FAILED\",\"z\":\"x\"}";
    assertThatThrownBy(() -> wire.decodeResult(failed.getBytes(UTF_8)))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("error");
    assertThat(schemas.faults("result", failed.getBytes(UTF_8))).isNotEmpty();
  }

  @Test
  void doesNotWriteWhatJsonCannotHold() {
    for (Object value : List.of(Double.NaN, new Object(), Optional.of(1))) {
      Observation observation = new Observation("c", "rose", "f", Map.of("a", value));
      assertThatThrownBy(() -> wire.encode(observation))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("values.a");
    }
  }

  private MalformedMessageException refusal(String text) {
    return catchThrowableOfType(
        MalformedMessageException.class, () -> wire.decodeCall(text.getBytes(UTF_8)));
  }
}
