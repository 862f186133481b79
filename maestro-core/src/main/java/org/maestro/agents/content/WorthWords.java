package org.maestro.agents.content;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.coordination.api.Stakes;
import org.maestro.coordination.api.Worth;
import org.maestro.sl.Content;
import org.maestro.sl.Expression;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;

/** The worth of goals in messages: how stakes are stated, and how it is told what came of them. */
final class WorthWords {
  private static final List<String> MORE = List.of("chance", "allowed", "urgency");

  private WorthWords() {}

  /**
   * Reads {@code (:benefit 60)}, where the benefit may be an expression as a text, and {@code
   * (:chance 0.9) (:allowed 600) (:urgency 1 10)}.
   *
   * @throws InvalidGoalException when one of them makes no sense
   */
  static Optional<Stakes> stakes(Words words) {
    Optional<Term> benefit = words.term("benefit");
    if (benefit.isEmpty()) {
      MORE.stream()
          .filter(name -> words.named(name).isPresent())
          .findFirst()
          .ifPresent(
              name -> {
                throw new InvalidGoalException(
                    "The %s says nothing without a benefit; add one, such as (:benefit 60)."
                        .formatted(name));
              });
      return Optional.empty();
    }
    double chance = number(words, "chance", Stakes.USUAL_CHANCE, "a number from 0 to 1");
    if (chance < 0 || chance > 1) {
      throw new InvalidGoalException(
          "The chance %s is not from 0 to 1; write such a number, such as 0.8."
              .formatted(Words.plain(new Term.Number(chance))));
    }
    Optional<Double> allowed = GoalWords.number(words, "allowed", "seconds above 0, such as 600");
    if (allowed.isPresent() && !(allowed.get() > 0 && allowed.get() <= GoalWords.LATEST_SECONDS)) {
      throw new InvalidGoalException(
          "The time allowed is not between 0 s and ten years; write seconds, such as 600.");
    }
    List<Double> urgency = urgency(words);
    return Optional.of(
        new Stakes(
            benefit(benefit.get()),
            chance,
            allowed.map(seconds -> Duration.ofMillis(Math.round(seconds * 1000))),
            urgency.get(0),
            urgency.get(1)));
  }

  private static Expression benefit(Term stated) {
    if (stated instanceof Term.Number number) {
      return new Expression.OfTerm(number);
    }
    try {
      return SlParser.expression(Words.plain(stated));
    } catch (SlSyntaxException e) {
      throw new InvalidGoalException(
          "The benefit is no number: %s Write one, such as 60 or \"(+ 40 (level lamp-a1))\"."
              .formatted(e.getMessage()));
    }
  }

  private static double number(Words words, String name, double otherwise, String wanted) {
    return GoalWords.number(words, name, wanted).orElse(otherwise);
  }

  private static List<Double> urgency(Words words) {
    if (words.named("urgency").isEmpty()) {
      return List.of(Stakes.USUAL_URGENCY_FROM, Stakes.USUAL_URGENCY_TO);
    }
    List<Double> bounds = new ArrayList<>();
    for (Term term : words.find("urgency").map(Words::terms).orElse(List.of())) {
      if (term instanceof Term.Number number) {
        bounds.add(number.value());
      }
    }
    if (bounds.size() != 2 || !(bounds.get(0) > 0) || !(bounds.get(1) >= bounds.get(0))) {
      throw new InvalidGoalException(
          "The urgency needs two numbers above 0, the lower first; write such as (:urgency 1 10).");
    }
    return bounds;
  }

  /** The stakes in the words by which they are stated. */
  static Content.Argument.Named stated(Stakes stakes) {
    return Words.named(
        "stakes",
        new AskedStakes(
                Optional.of(SlPrinter.print(stakes.benefit())),
                Optional.of(stakes.chance()),
                stakes.allowed().map(time -> time.toMillis() / 1000.0),
                Optional.of(stakes.urgencyFrom()),
                Optional.of(stakes.urgencyTo()))
            .arguments());
  }

  /** What the goal is worth now; seconds are simulated ones. */
  static Content.Argument.Named told(Worth worth) {
    List<Content.Argument> numbers = new ArrayList<>();
    numbers.add(Words.named("chance", Words.number(worth.chance())));
    numbers.add(Words.named("tried", Words.number(worth.tried())));
    add(numbers, "benefit", worth.benefit());
    numbers.add(Words.named("cost", Words.number(worth.cost())));
    add(numbers, "utility", worth.utility());
    numbers.add(Words.named("elapsed", GoalWords.seconds(worth.elapsed())));
    worth.allowed().ifPresent(time -> numbers.add(Words.named("allowed", GoalWords.seconds(time))));
    numbers.add(Words.named("from", Words.number(worth.urgencyFrom())));
    numbers.add(Words.named("to", Words.number(worth.urgencyTo())));
    numbers.add(Words.named("urgency", Words.number(worth.urgency())));
    add(numbers, "priority", worth.priority());
    return Words.named("worth", numbers);
  }

  private static void add(List<Content.Argument> numbers, String name, OptionalDouble value) {
    value.ifPresent(number -> numbers.add(Words.named(name, Words.number(number))));
  }
}
