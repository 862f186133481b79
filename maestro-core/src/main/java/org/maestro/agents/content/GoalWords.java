package org.maestro.agents.content;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/** Goals in messages: how they are asked for and listed. */
public final class GoalWords {
  static final long LATEST_SECONDS = Duration.ofDays(3_653).toSeconds();

  private GoalWords() {}

  /**
   * Reads {@code (:priority 5)} and {@code (:deadline 60)}, the latter in simulated seconds from
   * now, and what the goal is worth: {@code (:benefit 60)}, {@code (:chance 0.8)}, {@code (:allowed
   * 600)}, {@code (:urgency 1 10)}.
   *
   * @throws InvalidGoalException when one of them is no number that makes sense
   */
  public static GoalRequest request(Formula goal, String requester, Words words, Duration now) {
    Optional<Double> priority = number(words, "priority", "a whole number, such as 5");
    Optional<Double> deadline = number(words, "deadline", "seconds above 0, such as 60");
    if (priority.isPresent() && priority.get() != Math.rint(priority.get())
        || priority.map(Math::abs).orElse(0.0) > Integer.MAX_VALUE) {
      throw new InvalidGoalException(
          "The priority " + priority.get() + " is no whole number; write one, such as 5.");
    }
    if (deadline.isPresent() && deadline.get() <= 0) {
      throw new InvalidGoalException(
          "The deadline is over before the goal begins; write seconds above 0, such as 60.");
    }
    if (deadline.isPresent() && deadline.get() > LATEST_SECONDS) {
      throw new InvalidGoalException(
          "The deadline is more than ten years away; leave it away, or write seconds, such as 60.");
    }
    return new GoalRequest(
        goal,
        requester,
        priority.map(Double::intValue).orElse(0),
        deadline.map(seconds -> now.plusMillis(Math.round(seconds * 1000))),
        WorthWords.stakes(words));
  }

  static Optional<Double> number(Words words, String name, String wanted) {
    Optional<Term> term = words.term(name);
    if (term.isPresent() && !(term.get() instanceof Term.Number)) {
      throw new InvalidGoalException(
          "The %s %s is no number; write %s.".formatted(name, Words.plain(term.get()), wanted));
    }
    return term.map(number -> ((Term.Number) number).value());
  }

  /** A line of the list of goals; ages and what is left of deadlines in simulated seconds. */
  public static Content status(GoalStatus goal) {
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("goal", Words.name(goal.id()), Words.text(goal.goal())));
    arguments.add(Words.named("requester", Words.text(goal.requester())));
    arguments.add(Words.named("state", Words.name(goal.state().name().toLowerCase(Locale.ROOT))));
    arguments.add(Words.named("detail", Words.text(goal.detail())));
    arguments.add(Words.named("priority", Words.number(goal.priority())));
    goal.timeLeft().ifPresent(left -> arguments.add(Words.named("deadline", seconds(left))));
    arguments.add(Words.named("age", seconds(goal.age())));
    arguments.add(Words.named("waits", goal.waits().stream().map(GoalWords::edge).toList()));
    goal.worth().ifPresent(worth -> arguments.add(WorthWords.told(worth)));
    goal.stakes().ifPresent(stakes -> arguments.add(WorthWords.stated(stakes)));
    return new Content("inform", arguments);
  }

  static Content.Argument seconds(Duration duration) {
    return Words.number(duration.toMillis() / 1000.0);
  }

  private static Content.Argument.Named edge(WaitsFor edge) {
    return Words.named("for", Words.text(edge.resource().inWords()), Words.name(edge.holder()));
  }

  /** An edge of the wait-for graph: who waits, for what, and who has it. */
  public static Content wait(WaitsFor edge) {
    return Words.content(
        "inform",
        Words.named("goal", Words.name(edge.goalId())),
        Words.named("kind", Words.name(edge.resource().kind().name().toLowerCase(Locale.ROOT))),
        Words.named("for", Words.text(edge.resource().inWords())),
        Words.named("holder", Words.name(edge.holder())));
  }
}
