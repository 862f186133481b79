package org.maestro.sl;

import java.util.List;

/**
 * The response format of a question that does not take any words, as surveys have them (ADE, 3.3;
 * A45).
 */
public sealed interface AnswerFormat {

  /**
   * One of several, each shown with a radio button.
   *
   * @param options two or more; of a thing its label is shown
   */
  record Choice(List<Term> options) implements AnswerFormat {
    public Choice {
      options = List.copyOf(options);
    }
  }

  /**
   * A number, shown as a slider.
   *
   * @param lowest number that can be set
   * @param highest number that can be set
   * @param step from one number that can be set to the next
   * @param lowestLabel what stands at the end of the lowest number; "": nothing
   * @param highestLabel what stands at the other end; "": nothing
   */
  record Slider(double lowest, double highest, double step, String lowestLabel, String highestLabel)
      implements AnswerFormat {
    /** How far from a step a number may be, in steps, and counts as on it: doubles are rounded. */
    private static final double ROUNDING = 1e-6;

    /** Whether the number can be set. */
    public boolean takes(double number) {
      return number >= lowest && number <= highest && isOnStep(number);
    }

    /** Whether some whole number of steps leads from the lowest number there. */
    public boolean isOnStep(double number) {
      double steps = (number - lowest) / step;
      return Math.abs(steps - Math.rint(steps)) < ROUNDING;
    }
  }
}
