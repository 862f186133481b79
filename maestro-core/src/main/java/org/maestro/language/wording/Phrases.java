package org.maestro.language.wording;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.maestro.language.grammar.Grammar;
import org.maestro.sl.SlPrinter;

/**
 * Phrases with places for what they speak of: {@code {place}}, or {@code {place dative}}, where it
 * takes a form. A name takes a form by its article: {@code irregular dative = die der}, and the
 * words after it by the ending of that form and article: {@code ending dative-die e$ en}.
 * Immutable.
 */
final class Phrases {
  private static final Pattern PLACE = Pattern.compile("\\{(\\w+)(?: ([\\w-]+))?}");
  private static final String LISTED = ", ";
  private static final double HUNDRED = 100;

  /** In the place of an article: there is none. */
  private static final String NONE = "-";

  private final Grammar grammar;

  Phrases(Grammar grammar) {
    this.grammar = grammar;
  }

  /** A phrase of the grammar. */
  String of(String phrase) {
    return grammar.phrase(phrase);
  }

  /** A phrase of the grammar with these values. */
  String of(String phrase, Map<String, String> values) {
    return filled(grammar.phrase(phrase), values);
  }

  /** The text with these values; a place for which there is none stays. */
  String filled(String text, Map<String, String> values) {
    return PLACE
        .matcher(text)
        .replaceAll(
            found -> {
              String value = values.get(found.group(1));
              return Matcher.quoteReplacement(
                  value == null
                      ? found.group()
                      : found.group(2) == null ? value : inForm(value, found.group(2)));
            });
  }

  /** Each of the names that are listed in the form. */
  private String inForm(String names, String form) {
    return Arrays.stream(names.split(LISTED))
        .map(name -> nameInForm(name, form))
        .collect(Collectors.joining(LISTED));
  }

  private String nameInForm(String name, String form) {
    List<String> words = new ArrayList<>(List.of(name.split(" ")));
    String article = article(name);
    if (article.isEmpty()) {
      words.add(0, NONE);
    }
    String determiner = article.isEmpty() ? NONE : article;
    words.set(0, grammar.inflection().of(determiner, form).replace('_', ' '));
    for (int i = 1; i < words.size(); i++) {
      String other = grammar.inflection().of(words.get(i), form + "-" + determiner);
      if (other.equals(words.get(i)) && !article.isEmpty()) {
        break;
      }
      words.set(i, other);
    }
    return String.join(" ", words.get(0).equals(NONE) ? words.subList(1, words.size()) : words);
  }

  /** The article before a name; "" when it has none. */
  String article(String name) {
    int blank = name.indexOf(' ');
    String first = blank < 0 ? "" : name.substring(0, blank).toLowerCase(Locale.ROOT);
    return grammar.list("article").contains(List.of(first)) ? first : "";
  }

  /** One after the other, the last by a word of its own. */
  String listed(List<String> parts) {
    int last = parts.size() - 1;
    return last <= 0
        ? String.join("", parts)
        : of(
            "answer-list",
            Map.of("first", String.join(LISTED, parts.subList(0, last)), "last", parts.get(last)));
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
  String digits(double number) {
    return SlPrinter.print(Math.round(number * HUNDRED) / HUNDRED).replace(".", of("decimal-mark"));
  }

  /**
   * Any thing of that kind.
   *
   * @param kind what the class is called, with its article if it has one
   */
  String any(String kind) {
    String noun = noun(kind);
    return of(
        grammar.list("vowel").contains(List.of(noun.substring(0, 1).toLowerCase(Locale.ROOT)))
            ? "any-vowel"
            : "any",
        Map.of("name", kind, "noun", noun));
  }

  /**
   * Each thing of that kind.
   *
   * @param kind what the class is called, with its article if it has one
   */
  String every(String kind) {
    return of("every", Map.of("name", kind, "noun", noun(kind)));
  }

  private String noun(String kind) {
    return article(kind).isEmpty() ? kind : kind.substring(kind.indexOf(' ') + 1);
  }

  /** A clause as a sentence of its own. */
  static String sentence(String clause) {
    String text = capitalized(clause.strip());
    return text.matches("(?s).*[.!?]") ? text : text + ".";
  }

  /** As it begins a sentence. */
  static String capitalized(String text) {
    return text.isEmpty()
        ? text
        : text.substring(0, 1).toUpperCase(Locale.ROOT) + text.substring(1);
  }
}
