package org.maestro.ontology.validation;

import jakarta.json.Json;
import jakarta.json.stream.JsonParser;
import jakarta.json.stream.JsonParserFactory;
import jakarta.json.stream.JsonParsingException;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** A value of a JSON text with the line at which it begins. Immutable. */
sealed interface JsonText {

  /** So deep a text may be nested; messages may be less. */
  int DEEPEST = 64;

  /** Made once: {@link Json} searches all jars for its provider each time that it is asked. */
  JsonParserFactory PARSERS = Json.createParserFactory(Map.of());

  /** From 1. */
  int line();

  /** An object with its members in their order, those of the same key too. */
  record Members(int line, List<Member> all) implements JsonText {
    public Members {
      all = List.copyOf(all);
    }

    Optional<JsonText> value(String key) {
      return all.stream().filter(one -> one.key().equals(key)).map(Member::value).findFirst();
    }
  }

  /**
   * A member of an object.
   *
   * @param line of its key
   */
  record Member(String key, int line, JsonText value) {}

  /** An array. */
  record Items(int line, List<JsonText> all) implements JsonText {
    public Items {
      all = List.copyOf(all);
    }
  }

  /** A text, a number, a truth value or nothing, as it is read. */
  record Scalar(int line, String text) implements JsonText {}

  /** The value itself, or those of an array. */
  default List<JsonText> each() {
    return this instanceof Items items ? items.all() : List.of(this);
  }

  /**
   * Reads a text.
   *
   * @throws JsonParsingException when it is no JSON, with the place
   */
  static JsonText parse(String text) {
    try (JsonParser parser = PARSERS.createParser(new StringReader(text))) {
      if (!parser.hasNext()) {
        throw new JsonParsingException("It is empty", parser.getLocation());
      }
      JsonText read = value(parser, parser.next(), 0);
      while (parser.hasNext()) {
        parser.next();
      }
      return read;
    }
  }

  private static JsonText value(JsonParser parser, JsonParser.Event event, int depth) {
    int line = (int) parser.getLocation().getLineNumber();
    if (depth > DEEPEST) {
      throw new JsonParsingException("It is nested too deeply", parser.getLocation());
    }
    return switch (event) {
      case START_OBJECT -> new Members(line, members(parser, depth));
      case START_ARRAY -> {
        List<JsonText> items = new ArrayList<>();
        for (var next = parser.next(); next != JsonParser.Event.END_ARRAY; next = parser.next()) {
          items.add(value(parser, next, depth + 1));
        }
        yield new Items(line, items);
      }
      case VALUE_STRING, VALUE_NUMBER -> new Scalar(line, parser.getString());
      default -> new Scalar(line, event.name());
    };
  }

  private static List<Member> members(JsonParser parser, int depth) {
    List<Member> members = new ArrayList<>();
    while (parser.next() == JsonParser.Event.KEY_NAME) {
      int line = (int) parser.getLocation().getLineNumber();
      String key = parser.getString();
      members.add(new Member(key, line, value(parser, parser.next(), depth + 1)));
    }
    return members;
  }
}
