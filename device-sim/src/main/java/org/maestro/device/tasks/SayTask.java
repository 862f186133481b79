package org.maestro.device.tasks;

import org.maestro.hal.Loudspeaker;
import org.maestro.rats.member.Execution;

/** Says a sentence aloud. */
final class SayTask extends DeviceProcedure {

  private static final int MOST_CHARACTERS = 2_000;

  private final Loudspeaker loudspeaker;

  SayTask(FeatureContext context) {
    this.loudspeaker = context.driver(Loudspeaker.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    loudspeaker.say(text(parameters), ending(execution));
  }

  private static String text(CallParameters parameters) {
    Object text = parameters.values().get("text");
    if (!(text instanceof String said) || said.isBlank() || said.length() > MOST_CHARACTERS) {
      throw new InvalidCallException(
          "The parameter text is what is to be said, of 1 to %d characters."
              .formatted(MOST_CHARACTERS));
    }
    return said;
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(loudspeaker.seconds(text(parameters)), 0);
  }
}
