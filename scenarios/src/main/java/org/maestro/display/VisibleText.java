package org.maestro.display;

/**
 * Text in which each character that is not seen but obeyed stands as its escape, such as <code>
 * &#92;u001b</code>: control characters, separators of lines, and what turns the direction of
 * writing. The escapes are those of JSON, so that a document stays what it was.
 */
public final class VisibleText {
  private VisibleText() {}

  /** For a place that has one line. */
  public static String line(String text) {
    return visible(text, false);
  }

  /** The same where line breaks and tabs belong to the form. */
  public static String lines(String text) {
    return visible(text, true);
  }

  private static String visible(String text, boolean severalLines) {
    if (text.chars().noneMatch(c -> isObeyed((char) c))) {
      return text;
    }
    StringBuilder visible = new StringBuilder();
    for (char c : text.toCharArray()) {
      if (isObeyed(c) && !(severalLines && (c == '\n' || c == '\t'))) {
        visible.append("\\u%04x".formatted((int) c));
      } else {
        visible.append(c);
      }
    }
    return visible.toString();
  }

  private static boolean isObeyed(char c) {
    return Character.isISOControl(c)
        || c == '\u2028'
        || c == '\u2029'
        || c == '\u061c'
        || c == '\u200e'
        || c == '\u200f'
        || c >= '\u202a' && c <= '\u202e'
        || c >= '\u2066' && c <= '\u2069';
  }
}
