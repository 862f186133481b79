package org.maestro.language.wording;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.home.Home;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Truth;

/** What is known of a question, in a sentence that names things as people do. Immutable. */
public final class AnswerWords {
  private static final int MOST = 8;
  private static final double LONG_AGO_SECONDS = 60;
  private static final double HOUR_SECONDS = 3600;
  private static final double HUNDRED = 100;

  private final Grammar grammar;
  private final Naming naming;

  public AnswerWords(Home home, Grammar grammar) {
    this.grammar = grammar;
    this.naming = new Naming(home, grammar);
  }

  /**
   * One answer.
   *
   * @param binding what stands for the variables that were asked for: names, numbers, texts
   * @param ageSeconds how long ago it was known
   */
  public record Found(Truth truth, Map<String, String> binding, OptionalDouble ageSeconds) {

    /**
     * The same, where only what was seen grows old: what a device tells of itself is so until it
     * tells otherwise.
     *
     * @param kind in which way the oldest of what it rests on is known, in small letters
     */
    public static Found of(
        Truth truth, Map<String, String> binding, String kind, OptionalDouble ageSeconds) {
      return new Found(
          truth, binding, kind.equals("observed") ? ageSeconds : OptionalDouble.empty());
    }
  }

  /** The sentence; of yes and no, of what was asked for, or that nobody knows. */
  public String of(List<Found> answers) {
    List<Found> certain = answers.stream().filter(one -> one.truth() == Truth.TRUE).toList();
    List<Found> bound = certain.stream().filter(one -> !one.binding().isEmpty()).toList();
    if (!bound.isEmpty()) {
      List<String> values = bound.stream().limit(MOST).map(this::values).distinct().toList();
      return sentence(values, bound.size() - MOST) + ago(bound);
    }
    if (!certain.isEmpty()) {
      return grammar.phrase("answer-yes") + ago(certain);
    }
    boolean isUnknown =
        answers.isEmpty() || answers.stream().anyMatch(one -> one.truth() == Truth.UNKNOWN);
    return isUnknown
        ? grammar.phrase("answer-unknown")
        : grammar.phrase("answer-no") + ago(answers);
  }

  /**
   * How many there are that are known to be so.
   *
   * @param whole whether of no others it is unknown
   */
  public String counted(List<Found> answers, boolean whole) {
    long certain = answers.stream().filter(one -> one.truth() == Truth.TRUE).count();
    return grammar
        .phrase(whole ? "answer-count" : "answer-count-known")
        .replace("{number}", Phrases.capitalized(number(certain)));
  }

  private String sentence(List<String> values, int more) {
    List<String> all = new ArrayList<>(values);
    if (more > 0) {
      all.add(grammar.phrase("answer-more").replace("{number}", number(more)));
    }
    int last = all.size() - 1;
    return Phrases.capitalized(
            last == 0
                ? all.get(0)
                : grammar
                    .phrase("answer-list")
                    .replace("{first}", String.join(", ", all.subList(0, last)))
                    .replace("{last}", all.get(last)))
        + ".";
  }

  private String values(Found answer) {
    return answer.binding().values().stream().map(this::value).collect(Collectors.joining(": "));
  }

  private String value(String text) {
    try {
      return SlPrinter.print(Math.round(Double.parseDouble(text) * HUNDRED) / HUNDRED)
          .replace(".", grammar.phrase("decimal-mark"));
    } catch (NumberFormatException e) {
      return naming.word(text);
    }
  }

  private String ago(List<Found> answers) {
    double oldest = answers.stream().mapToDouble(one -> one.ageSeconds().orElse(0)).max().orElse(0);
    if (oldest < LONG_AGO_SECONDS) {
      return "";
    }
    boolean isHours = oldest >= HOUR_SECONDS;
    long number = Math.round(oldest / (isHours ? HOUR_SECONDS : LONG_AGO_SECONDS));
    return " "
        + grammar
            .phrase(
                isHours
                    ? number == 1 ? "hour-ago" : "hours-ago"
                    : number == 1 ? "minute-ago" : "minutes-ago")
            .replace("{number}", number(number));
  }

  /** A small number in words. */
  private String number(long number) {
    return grammar.numbers().entrySet().stream()
        .filter(word -> word.getValue() == number)
        .map(Map.Entry::getKey)
        .findFirst()
        .orElse(String.valueOf(number));
  }
}
