package org.maestro.agents.supervision;

import org.maestro.agents.content.Words;
import org.maestro.sl.Content;

/**
 * The bus that a joining container is told of, and the words that are used there.
 *
 * @param words what the home adds to the shipped vocabulary, as Turtle; empty when it adds nothing
 */
public record Handover(String brokerUri, String site, String words) {
  /** Reads what {@link #inWords} has written. */
  public static Handover read(Words answer) {
    return new Handover(
        answer.string("broker").orElseThrow(),
        answer.string("site").orElseThrow(),
        answer.string("words").orElse(""));
  }

  public Content inWords() {
    return Words.content(
        "inform",
        Words.named("broker", Words.text(brokerUri)),
        Words.named("site", Words.text(site)),
        Words.named("words", Words.text(words)));
  }
}
