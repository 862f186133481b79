package org.maestro.text;

/**
 * Text in which each character that is not seen but obeyed stands as its escape, such as <code>
 * &#92;u001b</code>: control characters, separators of lines, what turns the direction of writing
 * or hides in it, and half characters, which UTF-8 cannot hold. The escapes are those of JSON, so
 * that a document stays what it was.
 */
public final class VisibleText {
  private static final int NON_JOINER = 0x200c;
  private static final int JOINER = 0x200d;

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
    if (text.codePoints().noneMatch(VisibleText::isObeyed)) {
      return text;
    }
    StringBuilder visible = new StringBuilder();
    text.codePoints()
        .forEach(
            c -> {
              if (isObeyed(c) && !(severalLines && (c == '\n' || c == '\t'))) {
                for (char half : Character.toChars(c)) {
                  visible.append("\\u%04x".formatted((int) half));
                }
              } else {
                visible.appendCodePoint(c);
              }
            });
    return visible.toString();
  }

  /** Scripts and pictures need joiners between their characters. */
  private static boolean isObeyed(int character) {
    return switch (Character.getType(character)) {
      case Character.CONTROL,
          Character.LINE_SEPARATOR,
          Character.PARAGRAPH_SEPARATOR,
          Character.SURROGATE ->
          true;
      case Character.FORMAT -> character != JOINER && character != NON_JOINER;
      default -> false;
    };
  }
}
