package org.maestro.console.api;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.maestro.console.questions.RefusalException;

/** Checks what was sent against its schema: an object of texts, numbers, and lists of texts. */
final class BodyCheck {
  private BodyCheck() {}

  /**
   * Checks it.
   *
   * @throws RefusalException with the first fault
   */
  static void check(String name, JsonNode body) {
    JsonNode schema = Schemas.named(name);
    List<String> members = new ArrayList<>();
    schema.path("properties").fieldNames().forEachRemaining(members::add);
    if (!body.isObject()) {
      throw RefusalException.badInput(
          "What is sent has to be an object with %s.".formatted(String.join(", ", members)));
    }
    body.fieldNames()
        .forEachRemaining(
            member -> {
              if (!members.contains(member)) {
                throw RefusalException.badInput(
                    "There is no member %s here; there are %s."
                        .formatted(member, String.join(", ", members)));
              }
            });
    for (JsonNode required : schema.path("required")) {
      if (!body.has(required.asText())) {
        throw RefusalException.badInput("The member " + required.asText() + " is missing.");
      }
    }
    for (String member : members) {
      List<String> types = types(schema.path("properties").path(member).path("type"));
      if (body.has(member) && types.stream().noneMatch(type -> is(type, body.get(member)))) {
        throw RefusalException.badInput(
            "The member %s is %s."
                .formatted(
                    member,
                    types.stream().map(BodyCheck::inWords).collect(Collectors.joining(" or "))));
      }
    }
  }

  private static List<String> types(JsonNode type) {
    List<String> types = new ArrayList<>();
    if (type.isTextual()) {
      types.add(type.asText());
    } else {
      type.forEach(one -> types.add(one.asText()));
    }
    return types;
  }

  private static boolean is(String type, JsonNode value) {
    return switch (type) {
      case "string" -> value.isTextual();
      case "number" -> value.isNumber();
      case "integer" -> value.canConvertToInt() && value.asDouble() == value.asInt();
      case "boolean" -> value.isBoolean();
      case "null" -> value.isNull();
      case "object" -> value.isObject();
      case "array" -> value.isArray() && isOfTexts(value);
      default -> throw new IllegalStateException("No body has a member of type " + type + ".");
    };
  }

  private static boolean isOfTexts(JsonNode array) {
    boolean texts = true;
    for (JsonNode item : array) {
      texts &= item.isTextual();
    }
    return texts;
  }

  private static String inWords(String type) {
    return switch (type) {
      case "string" -> "a text";
      case "integer" -> "a whole number";
      case "boolean" -> "true or false";
      case "null" -> "null";
      case "object" -> "an object";
      case "array" -> "a list of texts";
      default -> "a number";
    };
  }
}
