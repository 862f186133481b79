package org.maestro.coordination.api;

import java.util.List;
import java.util.Optional;
import org.maestro.sl.AnswerFormat;
import org.maestro.sl.SlPrinter;

/**
 * A sentence that somebody is to hear.
 *
 * @param part of the script that says it, such as G7.2; who hears two of the same part with the
 *     same text has heard one sentence twice, as after a restart
 * @param to a person or a room, by its name in the home
 * @param wanted an answer, where it is a question
 */
public record Speech(String part, String to, String text, Optional<Wanted> wanted) {

  /** One that wants no answer. */
  public Speech(String part, String to, String text) {
    this(part, to, text, Optional.empty());
  }

  /**
   * An answer that is wanted.
   *
   * @param type a class of the home, a datatype, or {@link #CHOICE} or {@link #SLIDER}
   * @param choices answers that would do, some of them where there are many; of a choice all
   * @param slider the numbers that would do, where it is one
   */
  public record Wanted(String type, List<String> choices, Optional<AnswerFormat.Slider> slider) {
    /** The type of which one of the choices is to be taken. */
    public static final String CHOICE = "choice";

    /** The type of which a number is to be set. */
    public static final String SLIDER = "slider";

    public Wanted {
      choices = List.copyOf(choices);
    }

    /** What can be chosen or set, as a sentence for people; empty where words will do. */
    public Optional<String> inWords() {
      if (slider.isPresent()) {
        AnswerFormat.Slider range = slider.get();
        return Optional.of(
            "From %s to %s, by steps of %s."
                .formatted(
                    end(range.lowest(), range.lowestLabel()),
                    end(range.highest(), range.highestLabel()),
                    SlPrinter.print(range.step())));
      }
      return type.equals(CHOICE)
          ? Optional.of("One of: " + String.join(", ", choices) + ".")
          : Optional.empty();
    }

    private static String end(double number, String label) {
      return SlPrinter.print(number) + (label.isEmpty() ? "" : " (" + label + ")");
    }

    /** One that is not set on a slider. */
    public Wanted(String type, List<String> choices) {
      this(type, choices, Optional.empty());
    }
  }

  /** The goal for which it is said. */
  public String goalId() {
    return GoalId.whole(part);
  }
}
