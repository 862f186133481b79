package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.maestro.agents.content.Words;
import org.maestro.ontology.floor.Pose;
import org.maestro.sl.Term;

/**
 * The members of a JSON object, written alike by all commands: each is always there, null where
 * there is nothing to say; lists are arrays, and what MAESTRO-SL calls a number is one.
 */
public record JsonMembers(ObjectNode node) {

  public static JsonMembers empty() {
    return new JsonMembers(new ObjectMapper().createObjectNode());
  }

  /** An object added to an array. */
  public static JsonMembers in(ArrayNode array) {
    return new JsonMembers(array.addObject());
  }

  /** An object under a name of another. */
  public JsonMembers in(String name) {
    return new JsonMembers(node.putObject(name));
  }

  /** A text; tables and messages have a dash, or nothing, in the place of none. */
  public JsonMembers text(String name, Optional<String> text) {
    text.filter(word -> !word.isEmpty() && !word.equals("-"))
        .ifPresentOrElse(word -> node.put(name, word), () -> node.putNull(name));
    return this;
  }

  public JsonMembers text(String name, String text) {
    return text(name, Optional.of(text));
  }

  public JsonMembers words(String name, Iterable<String> words) {
    words.forEach(node.putArray(name)::add);
    return this;
  }

  /** A number that may be none, or none that JSON has. */
  public JsonMembers number(String name, OptionalDouble number) {
    if (number.isPresent() && Double.isFinite(number.getAsDouble())) {
      node.put(name, number.getAsDouble());
    } else {
      node.putNull(name);
    }
    return this;
  }

  public JsonMembers number(String name, OptionalInt number) {
    number.ifPresentOrElse(whole -> node.put(name, whole), () -> node.putNull(name));
    return this;
  }

  public JsonMembers number(String name, double number) {
    return number(name, OptionalDouble.of(number));
  }

  /** The number that a message has under one name, under another. */
  public JsonMembers number(String name, Words words, String inWords) {
    return number(
        name,
        words.term(inWords).isPresent()
            ? OptionalDouble.of(words.number(inWords, Double.NaN))
            : OptionalDouble.empty());
  }

  public JsonMembers truth(String name, boolean truth) {
    node.put(name, truth);
    return this;
  }

  /** What variables or parameters stand for, by their names. */
  public JsonMembers terms(String name, Map<String, Term> terms) {
    ObjectNode bound = node.putObject(name);
    terms.forEach((variable, term) -> bound.set(variable, value(term)));
    return this;
  }

  public JsonMembers terms(String name, List<Term> terms) {
    ArrayNode array = node.putArray(name);
    terms.forEach(term -> array.add(value(term)));
    return this;
  }

  /** A term as JSON: numbers and truths as such, a pose as its numbers, all else as a text. */
  public static JsonNode value(Term term) {
    JsonNodeFactory nodes = JsonNodeFactory.instance;
    if (term instanceof Term.Number number) {
      return nodes.numberNode(number.value());
    }
    if (term instanceof Term.Truth truth) {
      return nodes.booleanNode(truth.value());
    }
    if (term instanceof Term.Text text && isPose(text.value())) {
      ArrayNode pose = nodes.arrayNode();
      Arrays.stream(Pose.numbers(text.value())).forEach(pose::add);
      return pose;
    }
    return nodes.textNode(Words.plain(term));
  }

  private static boolean isPose(String text) {
    try {
      Pose.parse(text);
      return true;
    } catch (IllegalArgumentException e) {
      return false;
    }
  }

  @Override
  public String toString() {
    return node.toString();
  }
}
