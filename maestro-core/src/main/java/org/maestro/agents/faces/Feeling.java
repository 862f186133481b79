package org.maestro.agents.faces;

import org.maestro.coordination.api.Mood;

/**
 * The look and the voice in which something is said.
 *
 * @param expression of the face, in the word that faces have for it
 * @param intensity of it; 0 to 1
 * @param stress of the voice; 0 to 1
 */
record Feeling(String expression, double intensity, double stress) {
  static final Feeling NEUTRAL = new Feeling(MoodWords.NEUTRAL, 0, 0);

  /** What was wanted is so. */
  static final Feeling GLAD = new Feeling("smile", 0.8, 0);

  /** What was wanted is not, or was not understood. */
  static final Feeling SORRY = new Feeling("frown", 0.7, 0);

  private static final String WORRY = "worry";
  private static final double STRESS_FROM = 0.5;

  /**
   * Stress as time runs out: none until half of it is over, and growing from then on. Where it
   * begins is assumed.
   *
   * @param timeUsed the share that is over; 0 to 1
   */
  static Feeling pressed(double timeUsed) {
    double stress = Math.max(0, timeUsed - STRESS_FROM) / (1 - STRESS_FROM);
    return stress == 0 ? NEUTRAL : new Feeling(WORRY, stress, stress);
  }

  /** Who shows worry has it in the voice, too (ADE, 3.3; A41). */
  static Feeling of(Mood mood) {
    String expression = MoodWords.expression(mood.word());
    return new Feeling(
        expression, mood.intensity(), expression.equals(WORRY) ? mood.intensity() : 0);
  }
}
