package org.maestro.device.tasks;

import java.util.Arrays;
import java.util.stream.Collectors;
import org.maestro.hal.Face;
import org.maestro.hal.FacialExpression;
import org.maestro.rats.member.Execution;

/** Has a face smile, frown, look worried, or none of these. */
final class ExpressTask extends DeviceProcedure {
  private static final double SECONDS = 0.4;

  private final Face face;

  ExpressTask(FeatureContext context) {
    this.face = context.driver(Face.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    face.express(
        expression(parameters.text("expression")),
        parameters.share("intensity", 1),
        ending(execution));
  }

  /**
   * @throws InvalidCallException when no face has one of that word
   */
  static FacialExpression expression(String word) {
    return FacialExpression.of(word)
        .orElseThrow(
            () ->
                new InvalidCallException(
                    "A face has no expression %s; it has %s."
                        .formatted(
                            word,
                            Arrays.stream(FacialExpression.values())
                                .map(FacialExpression::word)
                                .collect(Collectors.joining(", ")))));
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, 0);
  }
}
