package org.maestro.device.tasks;

import java.util.Optional;
import org.maestro.hal.Face;
import org.maestro.rats.member.Execution;

/**
 * Says a sentence with a face: as whom, with which expression, and looking at what it speaks of, is
 * so from its first word on. Where that is, need not be known to speak of it.
 */
final class SayWithFace extends DeviceProcedure {
  private final Face face;

  SayWithFace(FeatureContext context) {
    this.face = context.driver(Face.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    String text = parameters.text("text");
    double stress = parameters.share("stress", 0);
    Optional<String> expression = parameters.optionalText("expression");
    expression.ifPresent(ExpressTask::expression);
    Runnable say = () -> face.say(text, stress, ending(execution));
    Runnable look =
        () ->
            parameters
                .optionalPointer("about")
                .filter(thing -> thing.position().isPresent())
                .ifPresentOrElse(
                    thing ->
                        face.look(
                            thing.name(), thing.position().orElseThrow(), next(execution, say)),
                    say);
    Runnable express =
        () ->
            expression.ifPresentOrElse(
                word ->
                    face.express(
                        ExpressTask.expression(word),
                        parameters.share("intensity", 1),
                        next(execution, look)),
                look);
    parameters
        .optionalText("persona")
        .ifPresentOrElse(persona -> face.appear(persona, next(execution, express)), express);
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(face.seconds(parameters.text("text"), parameters.share("stress", 0)), 0);
  }
}
