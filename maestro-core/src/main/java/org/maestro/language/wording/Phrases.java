package org.maestro.language.wording;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.language.grammar.Grammar;
import org.maestro.sl.SlPrinter;

/** A language's phrases, with what is put into their places. Immutable. */
final class Phrases {
  private static final Pattern PLACE = Pattern.compile("\\{(\\w+)}");
  private static final double HUNDRED = 100;

  private final Grammar grammar;

  Phrases(Grammar grammar) {
    this.grammar = grammar;
  }

  String of(String name) {
    return grammar.phrase(name);
  }

  String of(String name, Map<String, String> values) {
    return filled(grammar.phrase(name), values);
  }

  /** A text with values in its places; a place without a value stays. */
  static String filled(String phrase, Map<String, String> values) {
    Matcher places = PLACE.matcher(phrase);
    return places.replaceAll(
        found -> Matcher.quoteReplacement(values.getOrDefault(found.group(1), found.group(0))));
  }

  /** One after the other, the last by a word of its own. */
  String listed(List<String> parts) {
    int last = parts.size() - 1;
    return last <= 0
        ? String.join("", parts)
        : of(
            "answer-list",
            Map.of("first", String.join(", ", parts.subList(0, last)), "last", parts.get(last)));
  }

  /** A number in words where it has one, else in digits, two of them behind its point at most. */
  String number(double number) {
    return grammar.numbers().entrySet().stream()
        .filter(word -> word.getValue() == number)
        .map(Map.Entry::getKey)
        .findFirst()
        .orElseGet(() -> digits(number));
  }

  /** The same in digits always. */
  static String digits(double number) {
    return SlPrinter.print(Math.round(number * HUNDRED) / HUNDRED);
  }

  /** Any thing of that kind. */
  String any(String noun) {
    return of(
        grammar.list("vowel").contains(List.of(noun.substring(0, 1).toLowerCase(Locale.ROOT)))
            ? "any-vowel"
            : "any",
        Map.of("noun", noun));
  }

  /** A clause as a sentence of its own. */
  static String sentence(String clause) {
    String text = capitalized(clause.strip());
    return text.matches("(?s).*[.!?]") ? text : text + ".";
  }

  static String capitalized(String text) {
    return text.isEmpty()
        ? text
        : text.substring(0, 1).toUpperCase(Locale.ROOT) + text.substring(1);
  }
}
