package org.maestro.rats.protocol;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** To whom a message is addressed can be told of many that cannot be read otherwise. */
class AddressesTest {

  private static final String CALL =
      "{\"v\":\"1.0\",\"id\":\"c1\",\"r\":\"rose\",\"f\":\"pick\",\"p\":{},\"t\":5,\"from\":\"cca\"}";
  private static final CallAddress ROSE = new CallAddress("c1", "rose");

  private final WireFormat wire = new WireFormat();

  @ParameterizedTest
  @ValueSource(
      strings = {
        CALL,
        "{\"id\":\"c1\",\"r\":\"rose\"}",
        "{\"r\":\"rose\",\"id\":\"c1\",\"f\":",
        "{\"id\":\"c1\",\"r\":\"rose\",\"p\":{\"a\":[[[[[[[[[[[[[[[[[[[[",
        "{\"v\":7,\"p\":{\"id\":\"x\",\"r\":\"y\"},\"id\":\"c1\",\"r\":\"rose\"}",
        "{\"list\":[{\"id\":\"x\"},\"r\"],\"id\":\"c1\",\"r\":\"rose\"}",
        "{\"id\":\"c1\",\"r\":\"rose\",\"id\":\"c2\",\"r\":\"tulip\"}"
      })
  void areReadUpToWhereAMessageBreaks(String call) {
    assertThat(wire.addressOf(bytes(call))).contains(ROSE);
    assertThat(wire.idOf(bytes(call))).contains("c1");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "c1",
        "\"id\"",
        "[\"id\",\"c1\"]",
        "[{\"id\":\"c1\",\"r\":\"rose\"}]",
        "{\"r\":\"rose\",\"id\":\"c1",
        "{\"r\":\"rose\",\"id\":7}",
        "{\"r\":\"rose\",\"id\":\"\"}",
        "{\"r\":\"rose\",\"id\":\"c 1\"}",
        "{\"r\":\"rose\",\"p\":{\"id\":\"c1\"}}"
      })
  void areNotGuessedWithoutAnId(String call) {
    assertThat(wire.addressOf(bytes(call))).isEmpty();
    assertThat(wire.idOf(bytes(call))).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{\"id\":\"c1\"}",
        "{\"id\":\"c1\",\"r\":\"\"}",
        "{\"id\":\"c1\",\"r\":7}",
        "{\"id\":\"c1\",\"r\":\"rose/tulip\"}",
        "{\"id\":\"c1\",\"r\":\"ros"
      })
  void areNotGuessedWithoutAMember(String call) {
    assertThat(wire.addressOf(bytes(call))).isEmpty();
    assertThat(wire.idOf(bytes(call))).contains("c1");
  }

  @Test
  void showASignForWhatIsNoCharacter() {
    assertThat(wire.idOf(bytes("{\"id\":\"c\\ud800\"}"))).contains("c\uFFFD");
    assertThat(wire.idOf("{\"id\":\"c\u00ff\"}".getBytes(ISO_8859_1))).contains("c\uFFFD");
  }

  @Test
  void areReadOfWhatIsNotTooLong() {
    assertThat(wire.addressOf(bytes(padded(WireFormat.MOST_BYTES)))).contains(ROSE);
    assertThat(wire.addressOf(bytes(padded(WireFormat.MOST_BYTES + 1)))).isEmpty();
    assertThat(wire.idOf(bytes(padded(WireFormat.MOST_BYTES + 1)))).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        CALL,
        "{\"r\":\"rose\" and no more",
        "{\"r\":\"no name\"}",
        "{\"p\":{\"r\":\"tulip\"},\"r\":\"rose\"}",
        "{\"r\":\"rose\",\"r\":\"tulip\"}"
      })
  void tellWhatIsForAnother(String call) {
    assertThat(wire.isForAnother(bytes(call), "tulip")).isTrue();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{\"r\":\"tulip\"}",
        "{\"p\":{\"r\":\"rose\"},\"r\":\"tulip\"}",
        "{\"r\":\"tulip\",\"r\":\"rose\"}",
        "{\"r\":\"\"}",
        "{\"r\":null}",
        "{\"r\":7}",
        "{\"r\":\"ros",
        "{\"id\":\"c1\"}",
        "{\"id\":\"c1\",\"to\":\"rose\"}",
        "{\"id\":\"c1\"",
        "{\"p\":{\"r\":\"rose\"}}",
        "[\"r\",\"rose\"]",
        "[{\"r\":\"rose\"}]",
        "\"r\"",
        "rose",
        ""
      })
  void takeForAnotherOnlyWhatSaysSo(String call) {
    assertThat(wire.isForAnother(bytes(call), "tulip")).isFalse();
  }

  @Test
  void areNotLookedForInWhatIsTooLong() {
    assertThat(wire.isForAnother(bytes(padded(WireFormat.MOST_BYTES)), "tulip")).isTrue();
    assertThat(wire.isForAnother(bytes(padded(WireFormat.MOST_BYTES + 1)), "tulip")).isFalse();
  }

  private static String padded(int length) {
    return CALL + " ".repeat(length - CALL.length());
  }

  private static byte[] bytes(String text) {
    return text.getBytes(UTF_8);
  }
}
