package org.maestro.language.grammar;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * A language's grammar. Immutable.
 *
 * @param language its tag, such as {@code en}
 * @param rules in the order in which they are preferred
 * @param patterns of which rules are made for each construction, with places for its verb and for
 *     what goes with it
 * @param numbers words for numbers, with their values; of several the first is said
 * @param times words that multiply the number before them, with their values
 * @param lists other words by the list's name: {@code filler}, {@code article}, {@code repair}
 * @param phrases what is said, by the phrase's name, with places in braces
 * @param spellings words that are written otherwise first, such as can't
 * @param reports how reports are said that are written in another language; none where they are
 *     written in this one
 */
public record Grammar(
    String language,
    List<Rule> rules,
    List<Rule> patterns,
    Inflection inflection,
    Map<String, Double> numbers,
    Map<String, Double> times,
    Map<String, Set<List<String>>> lists,
    Map<String, String> phrases,
    Map<String, String> spellings,
    List<ReportRule> reports) {
  /** The category of whole utterances. */
  public static final String START = "Utterance";

  public Grammar {
    rules = List.copyOf(rules);
    patterns = List.copyOf(patterns);
    numbers = Collections.unmodifiableMap(new LinkedHashMap<>(numbers));
    times = Map.copyOf(times);
    lists = Map.copyOf(lists);
    phrases = Map.copyOf(phrases);
    spellings = Map.copyOf(spellings);
    reports = List.copyOf(reports);
  }

  /** The same grammar with more rules after its own. */
  public Grammar with(List<Rule> others) {
    List<Rule> all = new ArrayList<>(rules);
    all.addAll(others);
    return new Grammar(
        language, all, patterns, inflection, numbers, times, lists, phrases, spellings, reports);
  }

  /** The same grammar with what another file says of reports, and with the phrases of that. */
  public Grammar withReports(Grammar other) {
    List<ReportRule> all = new ArrayList<>(reports);
    all.addAll(other.reports);
    Map<String, String> more = new LinkedHashMap<>(phrases);
    more.putAll(other.phrases);
    return new Grammar(
        language, rules, patterns, inflection, numbers, times, lists, more, spellings, all);
  }

  /** The words of a list; none when there is no such list. */
  public Set<List<String>> list(String name) {
    return lists.getOrDefault(name, Set.of());
  }

  /** The first of the other grammar's phrases, by their names, that this one has not. */
  public Optional<String> firstMissing(Grammar other) {
    return other.phrases.keySet().stream()
        .filter(name -> !phrases.containsKey(name))
        .sorted()
        .findFirst();
  }

  /** A phrase as it is said. */
  public String phrase(String name) {
    String phrase = phrases.get(name);
    if (phrase == null) {
      throw new IllegalStateException(
          "The grammar of %s has no phrase %s.".formatted(language, name));
    }
    return phrase;
  }
}
