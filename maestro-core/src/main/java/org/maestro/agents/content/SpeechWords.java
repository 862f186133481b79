package org.maestro.agents.content;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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

  /** An answer to a question, as it comes to the central agent. */
  public static Content answer(String part, String text, Optional<String> person) {
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("question", Words.name(part)));
    arguments.add(Words.named("text", Words.text(text)));
    person.ifPresent(name -> arguments.add(Words.named("for", Words.text(name))));
    return new Content("answer", arguments);
  }
}
