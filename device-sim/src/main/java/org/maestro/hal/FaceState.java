package org.maestro.hal;

import java.util.Optional;

/**
 * All that can be seen of a face at one moment.
 *
 * @param persona whose face it is, as people call it; "" nobody's
 * @param intensity of the expression; 0 to 1
 * @param gaze what it looks at; empty: straight ahead
 * @param gesture what it does with its head just now
 * @param pointing what its hand points at just now
 * @param spoken the sentence that it is saying, with its mouth in motion
 */
public record FaceState(
    String persona,
    FacialExpression expression,
    double intensity,
    Optional<Gaze> gaze,
    Optional<HeadGesture> gesture,
    Optional<Gaze> pointing,
    Optional<Spoken> spoken) {

  /** A face at rest, which is nobody's. */
  public static final FaceState AT_REST =
      new FaceState(
          "",
          FacialExpression.NEUTRAL,
          0,
          Optional.empty(),
          Optional.empty(),
          Optional.empty(),
          Optional.empty());

  /**
   * A sentence that is being said.
   *
   * @param stress of the voice: with it it is quicker and higher; 0 to 1
   */
  public record Spoken(String text, double stress) {}

  public FaceState of(String other) {
    return new FaceState(other, expression, intensity, gaze, gesture, pointing, spoken);
  }

  public FaceState with(FacialExpression other, double strength) {
    return new FaceState(persona, other, strength, gaze, gesture, pointing, spoken);
  }

  public FaceState looking(Optional<Gaze> there) {
    return new FaceState(persona, expression, intensity, there, gesture, pointing, spoken);
  }

  public FaceState moving(Optional<HeadGesture> head) {
    return new FaceState(persona, expression, intensity, gaze, head, pointing, spoken);
  }

  public FaceState pointing(Optional<Gaze> there) {
    return new FaceState(persona, expression, intensity, gaze, gesture, there, spoken);
  }

  public FaceState saying(Optional<Spoken> sentence) {
    return new FaceState(persona, expression, intensity, gaze, gesture, pointing, sentence);
  }
}
