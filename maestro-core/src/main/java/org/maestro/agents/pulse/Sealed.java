package org.maestro.agents.pulse;

/**
 * A text under the seal of a {@link SessionKey}. In writing: the session, the number and the seal
 * with blanks between them, then the text from the next line on.
 *
 * @param number counts what is sealed of its kind
 */
public record Sealed(String session, long number, String seal, String text) {
  private static final int WORDS = 3;

  public String write() {
    return "%s %d %s\n%s".formatted(session, number, seal, text);
  }

  /**
   * @throws IllegalArgumentException when it is none
   */
  public static Sealed read(String written) {
    int end = written.indexOf('\n');
    String[] words = written.substring(0, Math.max(0, end)).split(" ", -1);
    if (words.length != WORDS) {
      throw new IllegalArgumentException("What was heard is not sealed.");
    }
    try {
      return new Sealed(words[0], Long.parseLong(words[1]), words[2], written.substring(end + 1));
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("What was heard is sealed without a number.", e);
    }
  }
}
