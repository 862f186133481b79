package org.maestro.hal;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** The expressions that a face can have (ADE, 3.3; A41). */
public enum FacialExpression {
  NEUTRAL,
  SMILE,
  FROWN,
  WORRY;

  /** As it stands in calls and reports. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Empty when there is none of that word. */
  public static Optional<FacialExpression> of(String word) {
    return Arrays.stream(values()).filter(one -> one.word().equals(word)).findFirst();
  }
}
