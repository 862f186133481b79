package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Comma-separated values (RFC 4180). What a spreadsheet would take for a formula is written after
 * an apostrophe, so that nothing that somebody has answered is ever calculated.
 */
public final class Csv {
  private static final String END_OF_RECORD = "\r\n";

  /** Those that begin a formula in one spreadsheet or another, also as they are wide. */
  private static final String FORMULA =
      "(?s)\\s*[=+\\-@\\uff1d\\uff0b\\uff0d\\uff20].*|[\\t\\r\\n].*";

  private static final String NUMBER = "-?[0-9]+([.][0-9]+)?([eE]-?[0-9]+)?";

  private Csv() {}

  /**
   * @param columns names of members, which stand in the first record
   * @param rows objects with these members
   */
  static String of(List<String> columns, Iterable<JsonNode> rows) {
    StringBuilder text = new StringBuilder(record(columns));
    for (JsonNode row : rows) {
      text.append(record(columns.stream().map(name -> row.path(name).asText("")).toList()));
    }
    return text.toString();
  }

  private static String record(List<String> cells) {
    return cells.stream().map(Csv::cell).collect(Collectors.joining(",", "", END_OF_RECORD));
  }

  private static String cell(String value) {
    String harmless = value.matches(FORMULA) && !value.matches(NUMBER) ? "'" + value : value;
    return '"' + harmless.replace("\"", "\"\"") + '"';
  }
}
