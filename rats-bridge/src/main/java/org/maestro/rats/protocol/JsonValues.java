package org.maestro.rats.protocol;

import java.util.Map;

/**
 * The values that a message may hold: texts of whole characters, finite numbers, truth values,
 * lists and maps of them, no deeper than receivers read.
 */
final class JsonValues {

  private JsonValues() {}

  /**
   * @throws IllegalArgumentException at the first value that is none of them
   */
  static void require(Map<String, Object> values) {
    values.forEach((name, value) -> require(name, value, 1));
  }

  /**
   * @param around how many maps and lists the value is in
   */
  private static void require(String path, Object value, int around) {
    boolean nests = value instanceof Map<?, ?> || value instanceof Iterable<?>;
    if (nests && around >= WireFormat.MOST_NESTING) {
      throw broken(path, "is nested more than " + WireFormat.MOST_NESTING + " deep");
    }
    if (value instanceof Map<?, ?> map) {
      map.forEach(
          (name, inner) -> {
            if (!(name instanceof String)) {
              throw broken(path, "has a key that is no text");
            }
            require(path + "." + name, inner, around + 1);
          });
    } else if (value instanceof Iterable<?> items) {
      items.forEach(item -> require(path + "[]", item, around + 1));
    } else if (value instanceof Number number) {
      if (!Double.isFinite(number.doubleValue())) {
        throw broken(path, "is not finite");
      }
    } else if (value instanceof String text) {
      if (!WholeText.isWhole(text)) {
        throw broken(path, "holds half a character");
      }
    } else if (!(value instanceof Boolean)) {
      throw broken(path, "is neither text, number, truth value, list nor map");
    }
  }

  private static IllegalArgumentException broken(String path, String what) {
    return new IllegalArgumentException("A message cannot hold " + path + ": it " + what);
  }
}
