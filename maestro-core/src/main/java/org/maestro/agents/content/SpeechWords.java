package org.maestro.agents.content;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.coordination.api.AnswerRefusal;
import org.maestro.coordination.api.Mood;
import org.maestro.coordination.api.Speech;
import org.maestro.sl.Content;

/**
 * The wording of what people are to hear, as it comes to the desk: {@code (inform (:say "The light
 * is on.") (:to Bob) (:part G7.2))}; a question has {@code (:wanted boolean) (:choices "yes" "no")}
 * too.
 */
public final class SpeechWords {
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
            words.string("wanted").map(type -> new Speech.Wanted(type, words.strings("choices")))));
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

  /** An answer to a question, as it comes to the agent whose script asks. */
  public static Content answer(String part, String text, Optional<String> person) {
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("question", Words.name(part)));
    arguments.add(Words.named("text", Words.text(text)));
    person.ifPresent(name -> arguments.add(Words.named("for", Words.text(name))));
    return new Content("answer", arguments);
  }
}
