package org.maestro.rats.protocol;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What just fits is taken, by whoever writes and whoever reads; one more is refused by both. */
class LimitsTest {

  private static final String CALL =
      "{\"v\":\"1.0\",\"id\":\"c1\",\"f\":\"pick\",\"p\":{},\"t\":5,\"from\":\"cca\"}";
  private static final String PROGRESS =
      "{\"v\":\"1.0\",\"id\":\"c1\",\"from\":\"rose\",\"kind\":\"RUNNING\",\"fraction\":0.5}";
  private static final String STATE =
      "{\"v\":\"1.0\",\"id\":\"rose\",\"boot\":\"b\",\"z\":\"TEXT\"}";

  private final WireFormat wire = new WireFormat();
  private final Schemas schemas = new Schemas();

  @Test
  void bytesThatAreRead() {
    String longest = CALL + " ".repeat(WireFormat.MOST_BYTES - CALL.length());
    assertThat(wire.decodeCall(bytes(longest)).id()).isEqualTo("c1");
    assertThatThrownBy(() -> wire.decodeCall(bytes(longest + " ")))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessage("The message's payload must be at most 262144 bytes, but is 262145 bytes");
  }

  @Test
  void bytesThatAreWritten() {
    int bare = wire.encode(observation("")).length;
    String longest = "x".repeat(WireFormat.MOST_BYTES - bare);
    byte[] written = wire.encode(observation(longest));
    assertThat(written).hasSize(WireFormat.MOST_BYTES);
    assertThat(wire.decodeObservation(written).values()).isEqualTo(Map.of("a", longest));
    assertThatThrownBy(() -> wire.encode(observation(longest + "x")))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("The message c has 262145 bytes, and nobody reads more than 262144");
  }

  /** The message and its values are two levels; fourteen lists are within them. */
  @Test
  void levelsOfNesting() {
    Observation deepest = observation(nested(14));
    assertThat(wire.decodeObservation(wire.encode(deepest))).isEqualTo(deepest);
    assertThatThrownBy(() -> wire.encode(observation(nested(15))))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "A message cannot hold values.a%s: it is nested more than 16 deep"
                .formatted("[]".repeat(14)));
    String deep = CALL.replace("{}", "{\"a\":" + nested(14) + "}");
    assertThat(wire.decodeCall(bytes(deep)).parameters()).isEqualTo(Map.of("a", nested(14)));
    String tooDeep = CALL.replace("{}", "{\"a\":" + nested(15) + "}");
    assertThatThrownBy(() -> wire.decodeCall(bytes(tooDeep)))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("nested at most 16 deep");
  }

  @Test
  void aListThatHoldsItselfIsTooDeep() {
    List<Object> endless = new ArrayList<>();
    endless.add(endless);
    assertThatThrownBy(() -> wire.encode(observation(endless)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageEndingWith("it is nested more than 16 deep");
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "1", "0.0", "1.0", "0.5", "1e-9"})
  void fractions(String fraction) throws IOException {
    byte[] progress = bytes(PROGRESS.replace("0.5", fraction));
    schemas.assertValid("progress", progress);
    assertThat(wire.decodeProgress(progress).fraction()).isEqualTo(Double.parseDouble(fraction));
  }

  @ParameterizedTest
  @ValueSource(strings = {"1", "604800000", "5.0", "6.048e8"})
  void timesThatTheSchemaTakesForWhole(String time) throws IOException {
    byte[] call = bytes(CALL.replace("\"t\":5", "\"t\":" + time));
    schemas.assertValid("call", call);
    assertThat(wire.decodeCall(call).timeout().toMillis())
        .isEqualTo((long) Double.parseDouble(time));
  }

  @ParameterizedTest
  @ValueSource(strings = {"x", "\ud83d\ude00"})
  void charactersOfAText(String character) throws IOException {
    byte[] longest = bytes(STATE.replace("TEXT", character.repeat(8_192)));
    schemas.assertValid("state", longest);
    assertThat(wire.decodeState(longest).state()).isEqualTo(character.repeat(8_192));
    byte[] longer = bytes(STATE.replace("TEXT", character.repeat(8_193)));
    assertThat(schemas.faults("state", longer)).isNotEmpty();
    assertThatThrownBy(() -> wire.decodeState(longer))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageStartingWith("The message's z must be a text of at most 8192 characters");
  }

  @Test
  void charactersOfAnErrorAreCutBySenders() {
    String said = "why ".repeat(5_000);
    Result result =
        new Result(
            "c",
            "rose",
            Outcome.FAILED,
            "on",
            Map.of(),
            Optional.of(
                new RatsError(
                    ErrorCode.INTERNAL,
                    RatsError.Level.ERROR,
                    said,
                    Optional.of(said),
                    List.of(),
                    false)));
    RatsError read = wire.decodeResult(wire.encode(result)).error().orElseThrow();
    assertThat(read.message()).isEqualTo("why ".repeat(2_000) + "...");
    assertThat(read.hint()).contains("why ".repeat(2_000) + "...");
  }

  private static Observation observation(Object value) {
    return new Observation("c", "rose", "f", Map.of("a", value));
  }

  private static List<Object> nested(int levels) {
    List<Object> nested = List.of();
    for (int level = 1; level < levels; level++) {
      nested = Collections.singletonList(nested);
    }
    return nested;
  }

  private static byte[] bytes(String message) {
    return message.getBytes(UTF_8);
  }
}
