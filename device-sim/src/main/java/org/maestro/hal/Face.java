package org.maestro.hal;

/**
 * A face that expresses, looks, nods, points and moves its mouth as it speaks: that of a robot's
 * head, or one that is drawn (ADE, 3.3; A41, A42). It may be the face of one persona now, and of
 * another one later (ADE, 5; A90).
 *
 * <p>What is shown stays until something else is, but for gestures, pointing and speech, which have
 * an end. Each command's completion is told when what it asks for is there, or has ended. The
 * clock's thread only.
 */
public interface Face {

  /** As it is now. */
  FaceState state();

  /**
   * From now on it is the face of that persona.
   *
   * @param persona as people call it
   */
  void appear(String persona, Completion completion);

  /**
   * @param intensity 0 to 1
   */
  void express(FacialExpression expression, double intensity, Completion completion);

  /**
   * @param thing local name
   * @param at where it is; metres, in the home's coordinates
   */
  void look(String thing, Position at, Completion completion);

  /** Done when the head is still again. */
  void gesture(HeadGesture gesture, Completion completion);

  /**
   * Raises a hand towards something; done when the hand is down again.
   *
   * @param thing local name
   * @param at where it is; metres, in the home's coordinates
   */
  void point(String thing, Position at, Completion completion);

  /**
   * Says a sentence, for as long as which the mouth moves.
   *
   * @param stress of the voice; 0 to 1
   * @param completion done when the sentence is over
   */
  void say(String text, double stress, Completion completion);

  /** How long a sentence takes; seconds. */
  default double seconds(String text, double stress) {
    return SpeakingTime.seconds(text, stress);
  }
}
