package org.maestro.rats.protocol;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.rats.protocol.MemberState.Ended;

/** What need not be said, and the values that members are free to choose. */
class SpareFieldsTest {

  private static final String RESULT =
      "{\"v\":\"1.0\",\"id\":\"c1\",\"from\":\"rose\",\"outcome\":\"SUCCEEDED\",\"z\":\"on\"}";

  private final WireFormat wire = new WireFormat();
  private final Schemas schemas = new Schemas();

  @Test
  void statesComeBackWithTheCallsThatEnded() throws IOException {
    List<Ended> recent = new ArrayList<>();
    for (Outcome outcome : Outcome.values()) {
      recent.add(new Ended("c" + outcome.ordinal(), outcome));
    }
    MemberState state =
        new MemberState("rose", "b", "on", List.of(), List.of(), List.of(), List.of(), recent);
    schemas.assertValid("state", wire.encode(state));
    assertThat(wire.decodeState(wire.encode(state))).isEqualTo(state);
  }

  @Test
  void whatAStateDoesNotSayIsEmpty() {
    byte[] state = bytes("{\"v\":\"1.0\",\"id\":\"rose\",\"boot\":\"b\",\"z\":\"on\"}");
    assertThat(wire.decodeState(state))
        .isEqualTo(new MemberState("rose", "b", "on", List.of(), List.of(), List.of(), List.of()));
  }

  @Test
  void errorsComeBackWhetherOrNotItCanBeTriedAgain() {
    for (boolean retriable : new boolean[] {true, false}) {
      RatsError error =
          new RatsError(
              ErrorCode.TIMEOUT,
              RatsError.Level.INFO,
              "why",
              Optional.empty(),
              List.of(new RatsError.Reference("(on)", "true", false)),
              retriable);
      Result result =
          new Result("c", "rose", Outcome.TIMED_OUT, "on", Map.of(), Optional.of(error));
      assertThat(wire.decodeResult(wire.encode(result))).isEqualTo(result);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{\"a\":NaN}|NaN",
        "{\"a\":-Infinity}|-Infinity",
        "{\"a\":1e999}|Infinity",
        "{\"a\":\"x\",\"b\":null}|x"
      })
  void aMembersNumberThatIsNoneIsATextAndNothingIsLeftOut(String values, String told) {
    byte[] result = bytes(RESULT.replace("}", ",\"values\":" + values + "}"));
    assertThat(wire.decodeResult(result).values()).isEqualTo(Map.of("a", told));
  }

  @Test
  void aMembersOtherValuesStayAsTheyAre() {
    byte[] result =
        bytes(
            RESULT.replace(
                "}", ",\"values\":{\"a\":1,\"b\":0.5,\"c\":true,\"d\":[\"x\"],\"e\":{\"f\":2}}}"));
    assertThat(wire.decodeResult(result).values())
        .isEqualTo(Map.of("a", 1, "b", 0.5, "c", true, "d", List.of("x"), "e", Map.of("f", 2)));
    assertThat(wire.decodeResult(bytes(RESULT)).values()).isEmpty();
  }

  @Test
  void whatCannotBeWrittenIsNamed() {
    assertUnwritable(List.of(1, Double.NaN), "values.a[]: it is not finite");
    assertUnwritable(Map.of("b", Double.POSITIVE_INFINITY), "values.a.b: it is not finite");
    assertUnwritable(Map.of("b", List.of("\ud800")), "values.a.b[]: it holds half a character");
    assertUnwritable(Map.of(1, 2), "values.a: it has a key that is no text");
    assertUnwritable(
        Set.of('x'), "values.a[]: it is neither text, number, truth value, list nor map");
  }

  private void assertUnwritable(Object value, String words) {
    Observation observation = new Observation("c", "rose", "f", Map.of("a", value));
    assertThatThrownBy(() -> wire.encode(observation))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("A message cannot hold " + words);
  }

  private static byte[] bytes(String message) {
    return message.getBytes(UTF_8);
  }
}
