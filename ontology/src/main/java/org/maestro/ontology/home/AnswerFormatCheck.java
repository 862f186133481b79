package org.maestro.ontology.home;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BiConsumer;
import org.maestro.sl.AnswerFormat;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * Checks the response formats of questions: that people can choose, and what a slider can be at.
 */
final class AnswerFormatCheck {
  /** So that each option fits on a screen, and each step of a slider can be met. */
  private static final int MOST_OPTIONS = 50;

  private static final int MOST_STEPS = 10_000;

  private static final List<String> A_NUMBER = List.of("decimal");
  private static final List<String> A_TEXT = List.of("string");

  private final BiConsumer<String, String> problems;

  AnswerFormatCheck(BiConsumer<String, String> problems) {
    this.problems = problems;
  }

  void check(AnswerFormat format) {
    if (format instanceof AnswerFormat.Choice choice) {
      check(choice);
    } else {
      check((AnswerFormat.Slider) format);
    }
  }

  private void check(AnswerFormat.Choice choice) {
    Set<Term> different = new HashSet<>(choice.options());
    if (different.size() < choice.options().size()) {
      problems.accept("has the same option twice in a choice", "write it once");
    }
    if (choice.options().size() < 2 || choice.options().size() > MOST_OPTIONS) {
      problems.accept(
          "has a choice of %d".formatted(choice.options().size()),
          "write from two to %d options, such as (choice \"good\" \"bad\")"
              .formatted(MOST_OPTIONS));
    }
  }

  private void check(AnswerFormat.Slider slider) {
    double steps = (slider.highest() - slider.lowest()) / slider.step();
    if (!(slider.lowest() < slider.highest() && slider.step() > 0)
        || steps > MOST_STEPS
        || !slider.isOnStep(slider.highest())) {
      problems.accept(
          "has a slider from %s to %s by steps of %s"
              .formatted(
                  SlPrinter.print(slider.lowest()),
                  SlPrinter.print(slider.highest()),
                  SlPrinter.print(slider.step())),
          "let whole steps, %d at most, lead from the lowest number to the highest, such as"
                  .formatted(MOST_STEPS)
              + " (slider 1 7 1)");
    }
  }

  /** The datatype of what is answered; none where it may be one or another. */
  static List<String> types(AnswerFormat format) {
    if (format instanceof AnswerFormat.Choice choice) {
      return choice.options().stream().allMatch(Term.Text.class::isInstance)
          ? A_TEXT
          : choice.options().stream().allMatch(Term.Number.class::isInstance)
              ? A_NUMBER
              : List.of();
    }
    return A_NUMBER;
  }
}
