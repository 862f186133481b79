package org.maestro.language.wording;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Truth;

/** What is known of a question, in a sentence that names things as people do. Immutable. */
public final class AnswerWords {
  private static final int MOST = 8;
  private static final double LONG_AGO_SECONDS = 60;
  private static final double MILLIS = 1000;

  /** What is less sure than that is told as likely. */
  private static final double SURE = 0.95;

  private final Grammar grammar;
  private final Naming naming;
  private final Phrases phrases;
  private final AmountWords amounts;
  private final SpanWords spans;

  public AnswerWords(Home home, Grammar grammar) {
    this.grammar = grammar;
    this.naming = new Naming(home, grammar);
    this.phrases = new Phrases(grammar);
    this.amounts = new AmountWords(home, grammar);
    this.spans = new SpanWords(grammar);
  }

  /**
   * One answer.
   *
   * @param binding what stands for the variables that were asked for: names, numbers, texts
   * @param ageSeconds how long ago it was known
   * @param confidence how surely it is known, 0 to 1
   */
  public record Found(
      Truth truth, Map<String, String> binding, OptionalDouble ageSeconds, double confidence) {

    /** What is known for sure. */
    public Found(Truth truth, Map<String, String> binding, OptionalDouble ageSeconds) {
      this(truth, binding, ageSeconds, 1);
    }

    /**
     * The same, where only what was seen grows old: what a device tells of itself is so until it
     * tells otherwise.
     *
     * @param kind in which way the oldest of what it rests on is known, in small letters
     */
    public static Found of(
        Truth truth,
        Map<String, String> binding,
        String kind,
        OptionalDouble ageSeconds,
        double confidence) {
      return new Found(
          truth,
          binding,
          kind.equals("observed") ? ageSeconds : OptionalDouble.empty(),
          confidence);
    }

    private boolean isOnlyLikely() {
      return confidence < SURE;
    }
  }

  /** The sentence; of yes and no, of what was asked for, or that nobody knows. */
  public String of(List<Found> answers) {
    return of(answers, Optional.empty());
  }

  /**
   * The same.
   *
   * @param fluent of which a number was asked for
   */
  public String of(List<Found> answers, Optional<String> fluent) {
    List<Found> certain = answers.stream().filter(one -> one.truth() == Truth.TRUE).toList();
    List<Found> bound = certain.stream().filter(one -> !one.binding().isEmpty()).toList();
    if (!bound.isEmpty()) {
      List<String> values =
          bound.stream().limit(MOST).map(one -> values(one, fluent)).distinct().toList();
      return sentence(values, bound.size() - MOST) + ago(bound);
    }
    if (!certain.isEmpty()) {
      return grammar.phrase(
              certain.stream().allMatch(Found::isOnlyLikely) ? "answer-likely-yes" : "answer-yes")
          + ago(certain);
    }
    return isUnknown(answers)
        ? grammar.phrase("answer-unknown")
        : grammar.phrase("answer-no") + ago(answers);
  }

  /** Whether nobody knows an answer. */
  public static boolean isUnknown(List<Found> answers) {
    return answers.stream().noneMatch(one -> one.truth() == Truth.TRUE)
        && (answers.isEmpty() || answers.stream().anyMatch(one -> one.truth() == Truth.UNKNOWN));
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
        .replace("{number}", Phrases.capitalized(phrases.number((double) certain)));
  }

  private String sentence(List<String> values, int more) {
    List<String> all = new ArrayList<>(values);
    if (more > 0) {
      all.add(phrases.of("answer-more", Map.of("number", phrases.number(more))));
    }
    return Phrases.capitalized(phrases.listed(all)) + ".";
  }

  private String values(Found answer, Optional<String> fluent) {
    List<String> values =
        answer.binding().values().stream()
            .map(text -> value(text, fluent))
            .collect(Collectors.toCollection(ArrayList::new));
    if (answer.isOnlyLikely()) {
      int last = values.size() - 1;
      values.set(last, phrases.of("answer-likely", Map.of("value", values.get(last))));
    }
    return String.join(": ", values);
  }

  private String value(String text, Optional<String> fluent) {
    try {
      double number = Double.parseDouble(text);
      return fluent.map(name -> amounts.of(name, number)).orElseGet(() -> phrases.digits(number));
    } catch (NumberFormatException e) {
      return naming.word(text);
    }
  }

  private String ago(List<Found> answers) {
    double oldest = answers.stream().mapToDouble(one -> one.ageSeconds().orElse(0)).max().orElse(0);
    return oldest < LONG_AGO_SECONDS
        ? ""
        : " "
            + phrases.of(
                "that-was",
                Map.of("ago", spans.ago(Duration.ofMillis(Math.round(oldest * MILLIS)))));
  }
}
