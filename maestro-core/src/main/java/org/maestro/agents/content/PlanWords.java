package org.maestro.agents.content;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.coordination.api.BidRecord;
import org.maestro.coordination.api.PlanRecord;
import org.maestro.coordination.api.ScriptStep;
import org.maestro.coordination.api.StepRecord;
import org.maestro.sl.Content;
import org.maestro.sl.Content.Argument;

/**
 * Plans that were made for a goal, and steps of scripts, in messages; times in simulated seconds.
 */
public final class PlanWords {
  private PlanWords() {}

  /** A plan with its steps, or the round that brought none. */
  public static Content plan(PlanRecord plan) {
    List<Argument> words = new ArrayList<>();
    words.add(Words.named("plan", Words.number(plan.number())));
    words.add(time("asked", plan.asked()));
    plan.cause().ifPresent(cause -> words.add(Words.named("cause", Words.text(cause))));
    words.add(Words.named("notAsked", Words.number(plan.notAsked())));
    plan.made()
        .ifPresent(
            made -> {
              words.add(time("made", made.at()));
              words.add(Words.named("purpose", Words.name(made.toSee() ? "see" : "reach")));
              words.add(Words.named("cost", Words.number(made.cost())));
              words.add(time("lasts", made.lasts()));
              words.add(Words.named("steps", made.steps().stream().map(PlanWords::step).toList()));
            });
    return new Content("inform", words);
  }

  /** A step of a script that is carried out. */
  public static Content step(ScriptStep step) {
    List<Argument> words = new ArrayList<>();
    words.add(Words.named("path", Words.text(step.path())));
    words.add(Words.named("depth", Words.number(step.depth())));
    words.add(Words.named("text", Words.text(step.text())));
    words.add(Words.named("state", name(step.state())));
    became(words, step.begun(), step.ended(), step.problem());
    return new Content("inform", words);
  }

  private static void became(
      List<Argument> words,
      Optional<Duration> begun,
      Optional<Duration> ended,
      Optional<String> problem) {
    begun.ifPresent(time -> words.add(time("begun", time)));
    ended.ifPresent(time -> words.add(time("ended", time)));
    problem.ifPresent(why -> words.add(Words.named("problem", Words.text(why))));
  }

  private static Argument.Named step(StepRecord record) {
    List<Argument> words = new ArrayList<>();
    words.add(Words.named("number", Words.number(record.step().number())));
    words.add(Words.named("text", Words.text(record.sentence())));
    words.add(Words.named("member", Words.name(record.step().member())));
    words.add(Words.named("feature", Words.name(record.step().feature().name())));
    words.add(
        Words.named("after", record.step().after().stream().sorted().map(Words::number).toList()));
    words.add(Words.named("cost", Words.number(record.step().cost())));
    words.add(Words.named("seconds", Words.number(record.step().seconds())));
    words.add(time("start", record.start()));
    words.add(Words.named("state", name(record.state())));
    became(words, record.begun(), record.ended(), record.problem());
    return Words.named("step", words);
  }

  /** What came of asking one member for one of its features. */
  public static Content bid(BidRecord bid) {
    List<Argument> words = new ArrayList<>();
    bid.step().ifPresent(step -> words.add(Words.named("step", Words.number(step))));
    words.add(Words.named("member", Words.name(bid.member())));
    words.add(Words.named("feature", Words.name(bid.feature())));
    words.add(Words.named("chosen", Words.name(String.valueOf(bid.chosen()))));
    if (bid.answer() instanceof BidRecord.Priced priced) {
      words.add(Words.named("answer", name(priced.kind())));
      number(words, "cost", priced.cost());
      number(words, "seconds", priced.seconds());
    } else if (bid.answer() instanceof BidRecord.Refused refused) {
      words.add(Words.named("answer", Words.name("refused")));
      words.add(Words.named("reason", Words.text(refused.reason())));
    } else if (bid.answer() instanceof BidRecord.NotAsked left) {
      words.add(Words.named("answer", Words.name("not-asked")));
      words.add(Words.named("reason", Words.text(left.reason())));
    }
    return new Content("inform", words);
  }

  private static void number(List<Argument> words, String name, OptionalDouble number) {
    number.ifPresent(value -> words.add(Words.named(name, Words.number(value))));
  }

  private static Argument.Named time(String name, Duration time) {
    return Words.named(name, Words.number(time.toMillis() / 1000.0));
  }

  private static Argument name(Enum<?> value) {
    return Words.name(value.name().toLowerCase(Locale.ROOT).replace('_', '-'));
  }
}
