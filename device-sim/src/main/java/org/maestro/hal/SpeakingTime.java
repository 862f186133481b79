package org.maestro.hal;

/** How long a sentence takes to be said. */
final class SpeakingTime {
  /** 150 words a minute; assumed, within what is usual of conversation in English. */
  private static final double WORDS_PER_SECOND = 2.5;

  /** Share of words more under stress; assumed. */
  private static final double QUICKER_UNDER_STRESS = 0.25;

  private SpeakingTime() {}

  /**
   * @param stress 0 to 1
   * @return seconds, at least those of one word
   */
  static double seconds(String text, double stress) {
    String[] words = text.strip().split("\\s+");
    return words.length / (WORDS_PER_SECOND * (1 + QUICKER_UNDER_STRESS * stress));
  }
}
