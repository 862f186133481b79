package org.maestro.agents.content;

import java.util.Optional;
import org.maestro.coordination.api.Speech;
import org.maestro.sl.Content;

/**
 * The wording of what people are to hear, as it comes to the desk: {@code (inform (:say "The light
 * is on.") (:to Bob) (:part G7.2))}.
 */
public final class SpeechWords {
  private SpeechWords() {}

  public static Content content(Speech speech) {
    return Words.content(
        "inform",
        Words.named("say", Words.text(speech.text())),
        Words.named("to", Words.name(speech.to())),
        Words.named("part", Words.name(speech.part())));
  }

  /** What {@link #content} wrote; empty: it is something else, or lacks a part. */
  public static Optional<Speech> read(Content content) {
    Words words = Words.of(content);
    Optional<String> text = words.string("say");
    Optional<String> to = words.string("to");
    Optional<String> part = words.string("part");
    return content.operator().equals("inform")
            && text.isPresent()
            && to.isPresent()
            && part.isPresent()
        ? Optional.of(new Speech(part.get(), to.get(), text.get()))
        : Optional.empty();
  }
}
