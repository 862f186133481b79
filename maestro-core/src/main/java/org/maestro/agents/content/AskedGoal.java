package org.maestro.agents.content;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.sl.Content;

/**
 * A goal as it is asked for in a message, with all that may be said of it. What is wrong with it is
 * told by whom it is asked of.
 *
 * @param goal in MAESTRO-SL
 * @param priority 0 is usual; a higher one goes first
 * @param deadlineSeconds simulated seconds from now by which it has to be reached
 * @param person for whom the desk asks, by the name by which she has signed in
 * @param speaker the person of the home on whose behalf it is asked for
 * @param stakes what it is worth
 */
public record AskedGoal(
    String goal,
    int priority,
    Optional<Double> deadlineSeconds,
    Optional<String> person,
    Optional<String> speaker,
    AskedStakes stakes) {

  /** A goal of which nothing more is said. */
  public AskedGoal(String goal) {
    this(goal, 0, Optional.empty(), Optional.empty(), Optional.empty(), AskedStakes.NONE);
  }

  public AskedGoal priority(int other) {
    return new AskedGoal(goal, other, deadlineSeconds, person, speaker, stakes);
  }

  /** From when it is stated on, by the platform's clock. */
  public AskedGoal deadline(Duration time) {
    return deadlineSeconds(Optional.of(time.toMillis() / 1000.0));
  }

  public AskedGoal deadlineSeconds(Optional<Double> seconds) {
    return new AskedGoal(goal, priority, seconds, person, speaker, stakes);
  }

  public AskedGoal person(Optional<String> name) {
    return new AskedGoal(goal, priority, deadlineSeconds, name, speaker, stakes);
  }

  /** Asked for on behalf of a person of the home. */
  public AskedGoal speaker(Optional<String> name) {
    return new AskedGoal(goal, priority, deadlineSeconds, person, name, stakes);
  }

  public AskedGoal stakes(AskedStakes other) {
    return new AskedGoal(goal, priority, deadlineSeconds, person, speaker, other);
  }

  /**
   * What it brings to have the goal reached.
   *
   * @param benefit a number, or an expression in MAESTRO-SL, in seconds of work
   */
  public AskedGoal benefit(String benefit) {
    return stakes(stakes.benefit(benefit));
  }

  /** The time within which its urgency grows to the highest. */
  public AskedGoal allowed(Duration time) {
    return stakes(stakes.allowed(time.toMillis() / 1000.0));
  }

  /** The content of the request. */
  public Content content() {
    List<Content.Argument> arguments = new ArrayList<>();
    person.ifPresent(name -> arguments.add(Words.named("for", Words.text(name))));
    speaker.ifPresent(name -> arguments.add(Words.named("speaker", Words.text(name))));
    arguments.add(Words.named("goal", Words.text(goal)));
    if (priority != 0) {
      arguments.add(Words.named("priority", Words.number(priority)));
    }
    deadlineSeconds.ifPresent(
        seconds -> arguments.add(Words.named("deadline", Words.number(seconds))));
    arguments.addAll(stakes.arguments());
    return new Content("initCNP", arguments);
  }
}
