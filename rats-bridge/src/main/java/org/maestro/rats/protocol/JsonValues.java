package org.maestro.rats.protocol;

import java.util.Map;

/**
 * What a message's values may be: texts of whole characters, finite numbers, truth values, lists
 * and maps of them.
 */
final class JsonValues {

  private JsonValues() {}

  /**
   * @throws IllegalArgumentException at the first value that is none of them
   */
  static void require(Map<String, Object> values) {
    values.forEach((name, value) -> require(name, value));
  }

  private static void require(String path, Object value) {
    if (value instanceof Map<?, ?> map) {
      map.forEach(
          (name, inner) -> {
            if (!(name instanceof String)) {
              throw broken(path, "has a key that is no text");
            }
            require(path + "." + name, inner);
          });
    } else if (value instanceof Iterable<?> items) {
      items.forEach(item -> require(path + "[]", item));
    } else if (value instanceof Number number) {
      if (!Double.isFinite(number.doubleValue())) {
        throw broken(path, "is not finite");
      }
    } else if (value instanceof String text) {
      requireWhole(path, text);
    } else if (!(value instanceof Boolean)) {
      throw broken(path, "is neither text, number, truth value, list nor map");
    }
  }

  private static void requireWhole(String path, String text) {
    for (int index = 0; index < text.length(); index++) {
      char unit = text.charAt(index);
      if (Character.isSurrogate(unit)) {
        boolean pair =
            Character.isHighSurrogate(unit)
                && index + 1 < text.length()
                && Character.isLowSurrogate(text.charAt(index + 1));
        if (!pair) {
          throw broken(path, "holds half a character");
        }
        index++;
      }
    }
  }

  private static IllegalArgumentException broken(String path, String what) {
    return new IllegalArgumentException("A message cannot hold " + path + ": it " + what);
  }
}
