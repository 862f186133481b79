package org.maestro.hal;

import java.util.List;

/**
 * All that a recogniser takes a sentence for so far: each one stands for itself, so that one that
 * is lost on its way is made good by the next.
 *
 * @param sentence counts the sentences that were heard since the recogniser was started, from 1
 * @param speaker whose voice it is, by the name that the home has for the person; "" unknown
 * @param words the sentence from its beginning
 * @param stable how many of the words, from the first on, will not be heard otherwise any more
 * @param confidence in the words, 0 to 1
 * @param alternatives for each word others that sound like it, the likeliest first
 * @param over whether the sentence has ended
 */
public record Hypothesis(
    int sentence,
    String speaker,
    List<String> words,
    int stable,
    double confidence,
    List<List<String>> alternatives,
    boolean over) {

  /** Before anything was heard. */
  public static final Hypothesis SILENCE = new Hypothesis(0, "", List.of(), 0, 1, List.of(), false);

  public Hypothesis {
    words = List.copyOf(words);
    alternatives = alternatives.stream().map(List::copyOf).toList();
  }
}
