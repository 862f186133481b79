package org.maestro.agents.content;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.maestro.knowledge.api.Answer;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Dispute;
import org.maestro.sl.Content;
import org.maestro.sl.Content.Argument;
import org.maestro.sl.Term;

/**
 * Beliefs as content of messages: what is believed, by whom, since when and how surely. Ages in
 * seconds.
 */
public final class BeliefWords {
  private static final double MILLIS_PER_SECOND = 1_000;
  private static final String AGE = "age";
  private static final String BINDING = "binding";

  private BeliefWords() {}

  public static Content content(Belief belief, Instant now) {
    return new Content("inform", arguments(belief, now));
  }

  private static List<Argument> arguments(Belief belief, Instant now) {
    return List.of(
        Words.named("fact", Words.text(belief.fact())),
        Words.named("source", Words.text(belief.source().agent())),
        Words.named("kind", Words.name(lower(belief.source().kind()))),
        Words.named("since", Words.text(belief.since().toString())),
        Words.named(AGE, Words.number(seconds(belief.age(now)))),
        Words.named("confidence", Words.number(belief.confidence())));
  }

  /** The truth, the binding if there is one, how old and sure the answer is, and on whose word. */
  public static Content content(Answer answer) {
    List<Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("truth", Words.name(lower(answer.truth()))));
    if (!answer.binding().isEmpty()) {
      arguments.add(Words.terms(BINDING, answer.binding()));
    }
    answer.age().ifPresent(age -> arguments.add(Words.named(AGE, Words.number(seconds(age)))));
    arguments.add(Words.named("confidence", Words.number(answer.confidence())));
    answer.because().forEach(b -> arguments.add(Words.named("because", arguments(b, answer.at()))));
    return new Content("inform", arguments);
  }

  public static Content content(Dispute dispute, Instant now) {
    List<Argument> arguments = new ArrayList<>();
    dispute
        .believed()
        .ifPresent(belief -> arguments.add(Words.named("believed", arguments(belief, now))));
    for (Dispute.Loser loser : dispute.losers()) {
      List<Argument> said = new ArrayList<>(arguments(loser.belief(), now));
      said.add(Words.named("rule", Words.text(loser.rule().sentence())));
      arguments.add(Words.named("loser", said));
    }
    return new Content("inform", arguments);
  }

  /** What was told then, with the ages of now. */
  public static Content later(Content told, Duration since) {
    return new Content(told.operator(), later(told.arguments(), since));
  }

  private static List<Argument> later(List<Argument> told, Duration since) {
    return told.stream().map(argument -> later(argument, since)).toList();
  }

  /** A variable may be called age, too, and what it stands for stays. */
  private static Argument later(Argument told, Duration since) {
    if (!(told instanceof Argument.Named named) || named.name().equals(BINDING)) {
      return told;
    }
    return named.name().equals(AGE)
        ? Words.named(AGE, Words.number(age(named) + seconds(since)))
        : new Argument.Named(named.name(), later(named.arguments(), since));
  }

  private static double age(Argument.Named told) {
    return Words.of(told).terms().get(0) instanceof Term.Number number ? number.value() : 0;
  }

  private static String lower(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT);
  }

  private static double seconds(Duration time) {
    return time.toMillis() / MILLIS_PER_SECOND;
  }
}
