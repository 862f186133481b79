package org.maestro.agents.content;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.sl.Content;

/**
 * The stakes of a goal as they are stated in a message; what is left out is as usual.
 *
 * @param benefit a number, or an expression in MAESTRO-SL, in seconds of work
 * @param chance that it is reached, as long as nothing like it was tried
 * @param allowedSeconds within which its urgency grows, simulated
 * @param urgencyFrom at the beginning; stated together with the other bound
 * @param urgencyTo when that time has passed
 */
public record AskedStakes(
    Optional<String> benefit,
    Optional<Double> chance,
    Optional<Double> allowedSeconds,
    Optional<Double> urgencyFrom,
    Optional<Double> urgencyTo) {
  /** Nothing is said of what it is worth. */
  public static final AskedStakes NONE =
      new AskedStakes(
          Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty());

  AskedStakes benefit(String other) {
    return new AskedStakes(Optional.of(other), chance, allowedSeconds, urgencyFrom, urgencyTo);
  }

  AskedStakes allowed(double seconds) {
    return new AskedStakes(benefit, chance, Optional.of(seconds), urgencyFrom, urgencyTo);
  }

  List<Content.Argument> arguments() {
    List<Content.Argument> arguments = new ArrayList<>();
    benefit.ifPresent(text -> arguments.add(Words.named("benefit", Words.text(text))));
    chance.ifPresent(number -> arguments.add(Words.named("chance", Words.number(number))));
    allowedSeconds.ifPresent(number -> arguments.add(Words.named("allowed", Words.number(number))));
    if (urgencyFrom.isPresent() || urgencyTo.isPresent()) {
      List<Content.Argument> bounds = new ArrayList<>();
      urgencyFrom.ifPresent(number -> bounds.add(Words.number(number)));
      urgencyTo.ifPresent(number -> bounds.add(Words.number(number)));
      arguments.add(Words.named("urgency", bounds));
    }
    return arguments;
  }
}
