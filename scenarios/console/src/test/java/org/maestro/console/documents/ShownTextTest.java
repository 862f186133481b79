package org.maestro.console.documents;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What looks like a secret is shown to nobody, and nothing that is shown is obeyed. */
class ShownTextTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "{\"password\":\"hunter2\",\"a\":1}    | {\"password\":\"•••\",\"a\":1}",
        "{\"wifiPassword\" : \"hun\\\"ter2\"}  | {\"wifiPassword\" : \"•••\"}",
        "{\"api_key\": 12345, \"b\": 2}        | {\"api_key\": •••, \"b\": 2}",
        "{\"access_token\": \"cut of           | {\"access_token\": \"•••\"",
        "(login (:user bob) (:password \"x y\")) | (login (:user bob) (:password \"•••\"))",
        "(login (:secret hunter2) (:user bob)) | (login (:secret •••) (:user bob))",
        "user=bob;password=hunter2;x=1         | user=bob;password=•••;x=1",
        "{\"member\": \"lamp\", \"z\": \"on\"}   | {\"member\": \"lamp\", \"z\": \"on\"}"
      })
  void secretsAreMasked(String text, String shown) {
    assertThat(ShownText.of(text)).isEqualTo(shown);
  }

  @Test
  void whatTurnsTheWritingIsAnEscape() {
    assertThat(ShownText.of("a\u202Eb")).isEqualTo("a\\u202eb");
  }

  @Test
  void noHalfCharacterIsLeft() {
    assertThat(ShownText.cut("ab\uD83D\uDE00", 3)).isEqualTo("ab");
  }
}
