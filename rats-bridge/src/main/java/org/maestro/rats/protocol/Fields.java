package org.maestro.rats.protocol;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** Reads the fields of one JSON object, each by its rule. Unknown fields are not looked at. */
final class Fields {

  private static final int MOST_SHOWN = 60;

  private final JsonNode object;
  private final String path;

  Fields(JsonNode object, String path) {
    this.object = object;
    this.path = path;
  }

  boolean has(String field) {
    return object.hasNonNull(field);
  }

  String text(String field, Rule rule) {
    JsonNode node = object.get(field);
    if (node == null || !node.isTextual() || !rule.allows(node.textValue())) {
      throw broken(field, rule.words(), node);
    }
    return whole(node.textValue(), path + field);
  }

  Optional<String> optionalText(String field, Rule rule) {
    return has(field) ? Optional.of(text(field, rule)) : Optional.empty();
  }

  /** Base64, with what fills it up to whole groups of four characters. */
  byte[] bytes(String field) {
    String text = text(field, Rule.DATA);
    try {
      return Base64.getDecoder().decode(text);
    } catch (IllegalArgumentException unreadable) {
      throw broken(field, Rule.DATA.words(), object.get(field));
    }
  }

  /** Also one that is written as 5.0, which JSON takes for the same number as 5. */
  long integer(String field, long least, long most) {
    JsonNode node = object.get(field);
    boolean fits = node != null && node.canConvertToExactIntegral() && node.canConvertToLong();
    if (!fits || node.longValue() < least || node.longValue() > most) {
      throw broken(field, "a whole number from " + least + " to " + most, node);
    }
    return node.longValue();
  }

  double fraction(String field) {
    return number(field, 1, "a number from 0 to 1");
  }

  double amount(String field) {
    return number(field, Double.MAX_VALUE, "a number from 0");
  }

  private double number(String field, double most, String rule) {
    JsonNode node = object.get(field);
    double value = node != null && node.isNumber() ? node.doubleValue() : Double.NaN;
    if (value >= 0 && value <= most) {
      return value;
    }
    throw broken(field, rule, node);
  }

  boolean truth(String field) {
    JsonNode node = object.get(field);
    if (node == null || !node.isBoolean()) {
      throw broken(field, "true or false", node);
    }
    return node.booleanValue();
  }

  <E extends Enum<E>> E constant(String field, Class<E> type) {
    Map<String, E> byName = new TreeMap<>();
    for (E constant : type.getEnumConstants()) {
      byName.put(constant.name(), constant);
    }
    return choice(field, byName);
  }

  /** A constant that this version does not know, as later minor versions may add some. */
  <E extends Enum<E>> E constantOr(E unknown, String field, Rule laterWord) {
    String word = text(field, laterWord);
    return Arrays.stream(unknown.getDeclaringClass().getEnumConstants())
        .filter(constant -> constant.name().equals(word))
        .findFirst()
        .orElse(unknown);
  }

  <E extends Enum<E>> E lowerCaseConstant(String field, Class<E> type) {
    Map<String, E> byName = new TreeMap<>();
    for (E constant : type.getEnumConstants()) {
      byName.put(constant.name().toLowerCase(Locale.ROOT), constant);
    }
    return choice(field, byName);
  }

  private <E> E choice(String field, Map<String, E> byName) {
    JsonNode node = object.get(field);
    E constant = node != null && node.isTextual() ? byName.get(node.textValue()) : null;
    if (constant == null) {
      throw broken(field, "one of " + String.join(", ", byName.keySet()), node);
    }
    return constant;
  }

  /** An absent object counts as empty. */
  Map<String, Object> values(String field) {
    JsonNode node = object.get(field);
    if (node == null) {
      return Map.of();
    }
    if (!node.isObject()) {
      throw broken(field, "an object", node);
    }
    return map(node, path + field);
  }

  /**
   * The same for what a member tells: what has no value is left out, and a number that is none is
   * told as a text, so that who knows what it should be can name it.
   */
  Map<String, Object> told(String field) {
    JsonNode node = object.get(field);
    if (node == null || !node.isObject()) {
      return values(field);
    }
    ObjectNode readable = node.deepCopy();
    readable.properties().removeIf(entry -> entry.getValue().isNull());
    readable
        .properties()
        .forEach(
            entry -> {
              JsonNode value = entry.getValue();
              if (value.isNumber() && !Double.isFinite(value.doubleValue())) {
                entry.setValue(TextNode.valueOf(value.asText()));
              }
            });
    return map(readable, path + field);
  }

  /** An absent list counts as empty. */
  List<String> texts(String field, Rule rule) {
    List<String> texts = new ArrayList<>();
    for (JsonNode item : list(field)) {
      if (!item.isTextual() || !rule.allows(item.textValue())) {
        throw broken(field + "[" + texts.size() + "]", rule.words(), item);
      }
      texts.add(whole(item.textValue(), path + field + "[" + texts.size() + "]"));
    }
    return List.copyOf(texts);
  }

  List<Fields> objects(String field) {
    List<Fields> objects = new ArrayList<>();
    for (JsonNode item : list(field)) {
      String name = field + "[" + objects.size() + "]";
      if (!item.isObject()) {
        throw broken(name, "an object", item);
      }
      objects.add(new Fields(item, path + name + "."));
    }
    return objects;
  }

  Fields object(String field) {
    JsonNode node = object.get(field);
    if (node == null || !node.isObject()) {
      throw broken(field, "an object", node);
    }
    return new Fields(node, path + field + ".");
  }

  /** A text, a number or a truth value. */
  Object scalar(String field) {
    JsonNode node = object.get(field);
    if (node == null || !node.isValueNode() || node.isNull()) {
      throw broken(field, "a text, a number, true or false", node);
    }
    return value(node, path + field);
  }

  private Iterable<JsonNode> list(String field) {
    JsonNode node = object.get(field);
    if (node == null) {
      return List.of();
    }
    if (!node.isArray()) {
      throw broken(field, "a list", node);
    }
    return node;
  }

  private static Map<String, Object> map(JsonNode object, String path) {
    Map<String, Object> values = new LinkedHashMap<>();
    object
        .properties()
        .forEach(
            entry ->
                values.put(
                    whole(entry.getKey(), path + "." + entry.getKey()),
                    value(entry.getValue(), path + "." + entry.getKey())));
    return Collections.unmodifiableMap(values);
  }

  private static Object value(JsonNode node, String path) {
    if (node.isTextual()) {
      return whole(node.textValue(), path);
    } else if (node.isBoolean()) {
      return node.booleanValue();
    } else if (node.isInt()) {
      return node.intValue();
    } else if (node.isLong()) {
      return node.longValue();
    } else if (node.isNumber() && Double.isFinite(node.doubleValue())) {
      return node.doubleValue();
    } else if (node.isObject()) {
      return map(node, path);
    } else if (node.isArray()) {
      List<Object> items = new ArrayList<>();
      node.forEach(item -> items.add(value(item, path + "[" + items.size() + "]")));
      return List.copyOf(items);
    }
    throw new MalformedMessageException(
        path, "a text, a finite number, true, false, a list or an object", shown(node));
  }

  /** A text with half a character could not be sent on, nor told to its sender. */
  private static String whole(String text, String path) {
    if (!WholeText.isWhole(text)) {
      throw new MalformedMessageException(
          WholeText.mended(path), "of whole characters", "one with half a character");
    }
    return text;
  }

  MalformedMessageException broken(String field, String rule, JsonNode found) {
    return new MalformedMessageException(path + field, rule, shown(found));
  }

  private static String shown(JsonNode node) {
    if (node == null) {
      return "absent";
    }
    return WholeText.shortened(node.toString(), MOST_SHOWN);
  }
}
