package org.maestro.agents.content;

import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.maestro.coordination.api.AnswerRefusal;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.coordination.api.Mood;
import org.maestro.coordination.api.Respondent;
import org.maestro.coordination.api.Speech;
import org.maestro.sl.AnswerFormat;
import org.maestro.sl.Content;
import org.maestro.sl.Term;

/**
 * The wording of what people are to hear, as it comes to the desk: {@code (inform (:say "The light
 * is on.") (:to Bob) (:part G7.2))}; a question has {@code (:wanted boolean) (:choices "yes" "no")}
 * too, and where a number is to be set {@code (:slider 1 7 1 "not at all" "very")}.
 */
public final class SpeechWords {
  private static final int SLIDER_TERMS = 5;

  private SpeechWords() {}

  public static Content content(Speech speech) {
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("say", Words.text(speech.text())));
    arguments.add(Words.named("to", Words.name(speech.to())));
    arguments.add(Words.named("part", Words.name(speech.part())));
    speech
        .wanted()
        .ifPresent(
            wanted -> {
              arguments.add(Words.named("wanted", Words.name(wanted.type())));
              arguments.add(
                  Words.named("choices", wanted.choices().stream().map(Words::text).toList()));
              wanted.slider().ifPresent(slider -> arguments.add(slider(slider)));
            });
    return new Content("inform", arguments);
  }

  /** What {@link #content} wrote; empty: it is something else, or lacks a part. */
  public static Optional<Speech> read(Content content) {
    Words words = Words.of(content);
    Optional<String> text = words.string("say");
    Optional<String> to = words.string("to");
    Optional<String> part = words.string("part");
    if (!content.operator().equals("inform") || text.isEmpty() || to.isEmpty() || part.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new Speech(
            part.get(),
            to.get(),
            text.get(),
            words
                .string("wanted")
                .map(type -> new Speech.Wanted(type, words.strings("choices"), slider(words)))));
  }

  private static Content.Argument.Named slider(AnswerFormat.Slider slider) {
    return Words.named(
        "slider",
        Words.number(slider.lowest()),
        Words.number(slider.highest()),
        Words.number(slider.step()),
        Words.text(slider.lowestLabel()),
        Words.text(slider.highestLabel()));
  }

  private static Optional<AnswerFormat.Slider> slider(Words words) {
    List<Term> terms = words.find("slider").map(Words::terms).orElse(List.of());
    return terms.size() == SLIDER_TERMS
            && terms.get(0) instanceof Term.Number lowest
            && terms.get(1) instanceof Term.Number highest
            && terms.get(2) instanceof Term.Number step
        ? Optional.of(
            new AnswerFormat.Slider(
                lowest.value(),
                highest.value(),
                step.value(),
                Words.plain(terms.get(3)),
                Words.plain(terms.get(4))))
        : Optional.empty();
  }

  /** {@code (inform (:express glad) (:intensity 0.8) (:part G7.2))}. */
  public static Content content(Mood mood) {
    return Words.content(
        "inform",
        Words.named("express", Words.name(mood.word())),
        Words.named("intensity", Words.number(mood.intensity())),
        Words.named("part", Words.name(mood.part())));
  }

  /** The same, read; empty: it is something else, or lacks a part. */
  public static Optional<Mood> mood(Content content) {
    Words words = Words.of(content);
    Optional<String> word = words.string("express");
    Optional<String> part = words.string("part");
    double intensity = words.number("intensity", -1);
    return content.operator().equals("inform")
            && word.isPresent()
            && part.isPresent()
            && intensity >= 0
            && intensity <= 1
        ? Optional.of(new Mood(part.get(), word.get(), intensity))
        : Optional.empty();
  }

  /**
   * What becomes of an answer, for who gave it.
   *
   * @param refusal empty when it is taken
   */
  public static Content verdict(String part, Optional<AnswerRefusal> refusal) {
    return refusal
        .map(
            why ->
                Words.content(
                    "inform",
                    Words.named("reason", Words.text(why.reason())),
                    Words.named("open", Words.name(String.valueOf(why.isOpen())))))
        .orElseGet(() -> Words.content("inform", Words.named("answered", Words.name(part))));
  }

  /**
   * An answer to a question, as it comes to the agent whose script asks.
   *
   * @param user for whom the desk asks, where somebody has signed in
   * @param person of the home whose answer it is, where that is known
   */
  public static Content answer(
      String part, String text, Optional<String> user, Optional<String> person) {
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("question", Words.name(part)));
    arguments.add(Words.named("text", Words.text(text)));
    user.ifPresent(name -> arguments.add(Words.named("for", Words.text(name))));
    person.ifPresent(name -> arguments.add(Words.named("person", Words.text(name))));
    return new Content("answer", arguments);
  }

  /**
   * An answer that was taken, as it comes to the desk to be kept: {@code (inform (:given "yes")
   * (:to Bob) (:part G7.2) ...)}.
   */
  public static Content given(GivenAnswer answer) {
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("given", Words.text(answer.answer())));
    arguments.add(Words.named("to", Words.name(answer.to())));
    arguments.add(Words.named("part", Words.name(answer.part())));
    arguments.add(Words.named("at", Words.text(answer.at().toString())));
    arguments.add(Words.named("script", Words.name(answer.script())));
    arguments.add(Words.named("goal", Words.text(answer.goal())));
    arguments.add(Words.named("question", Words.text(answer.question())));
    arguments.add(Words.named("by", Words.text(answer.by().caller())));
    answer.by().person().ifPresent(name -> arguments.add(Words.named("person", Words.text(name))));
    return new Content("inform", arguments);
  }

  /** What {@link #given(GivenAnswer)} wrote; empty: it is something else, or lacks a part. */
  public static Optional<GivenAnswer> given(Content content) {
    Words words = Words.of(content);
    boolean isWhole =
        Stream.of("given", "to", "part", "at", "script", "goal", "question", "by")
            .allMatch(name -> words.string(name).isPresent());
    if (!content.operator().equals("inform") || !isWhole) {
      return Optional.empty();
    }
    try {
      return Optional.of(
          new GivenAnswer(
              Instant.parse(words.string("at").orElseThrow()),
              words.string("script").orElseThrow(),
              words.string("goal").orElseThrow(),
              words.string("part").orElseThrow(),
              words.string("to").orElseThrow(),
              new Respondent(words.string("by").orElseThrow(), words.string("person")),
              words.string("question").orElseThrow(),
              words.string("given").orElseThrow()));
    } catch (DateTimeParseException noTime) {
      return Optional.empty();
    }
  }
}
