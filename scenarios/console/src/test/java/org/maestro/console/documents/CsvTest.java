package org.maestro.console.documents;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Records for spreadsheets, which calculate with what looks like a formula. */
class CsvTest {

  private static String cell(String value) {
    String text =
        Csv.of(List.of("a"), List.of(JsonNodeFactory.instance.objectNode().put("a", value)));
    assertThat(text).startsWith("\"a\"\r\n").endsWith("\r\n");
    return text.substring("\"a\"\r\n".length(), text.length() - "\r\n".length());
  }

  @Test
  void commasQuotesAndLineBreaksStayInTheirCell() {
    assertThat(cell("a, \"b\"\nc")).isEqualTo("\"a, \"\"b\"\"\nc\"");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "=1+1",
        "=cmd|' /C calc'!A0",
        "+1+1",
        "-1+1",
        "@SUM(A1)",
        "\t=1",
        " =1",
        "\r=1",
        "\n=1",
        "-2+3+cmd",
        "\uff1d1+1",
        "--1"
      })
  void whatWouldBeCalculatedIsAText(String formula) {
    assertThat(cell(formula)).isEqualTo("\"'" + formula + "\"");
  }

  @ParameterizedTest
  @ValueSource(strings = {"-3", "2.5", "-0.25", "1e-9", "no = way", "a-b", "", "mail@home"})
  void whatIsNoneStaysAsItIs(String text) {
    assertThat(cell(text)).isEqualTo('"' + text + '"');
  }
}
