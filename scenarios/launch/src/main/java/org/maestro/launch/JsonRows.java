package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** The rows of a document, as tables for people show them: with a dash for what is not there. */
final class JsonRows {
  private JsonRows() {}

  static <T> List<T> of(JsonNode array, Function<JsonNode, T> row) {
    List<T> rows = new ArrayList<>();
    array.forEach(node -> rows.add(row.apply(node)));
    return rows;
  }

  static String text(JsonNode row, String name) {
    return row.path(name).asText("-");
  }

  /** The words of a list, with blanks between. */
  static String words(JsonNode row, String name) {
    return row.path(name).isEmpty() ? "-" : plain(row.path(name));
  }

  /** A value as people write it in the language. */
  static String plain(JsonNode value) {
    if (value.isArray()) {
      return of(value, JsonRows::plain).stream().collect(Collectors.joining(" "));
    }
    return value.isNumber() ? SlPrinter.print(new Term.Number(value.asDouble())) : value.asText();
  }
}
