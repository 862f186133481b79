package org.maestro.sl;

/**
 * A text is not MAESTRO-SL. The message is one sentence that names the column and what was expected
 * there.
 */
public final class SlSyntaxException extends IllegalArgumentException {

  private static final long serialVersionUID = 1L;

  private final int column;
  private final String expected;
  private final String found;

  /**
   * @param column position in the text from 1, line breaks counted as one character
   * @param expected what would be right there
   * @param found what stands there
   */
  public SlSyntaxException(int column, String expected, String found) {
    super("At column " + column + " " + expected + " was expected, but found " + found + ".");
    this.column = column;
    this.expected = expected;
    this.found = found;
  }

  public int column() {
    return column;
  }

  public String expected() {
    return expected;
  }

  public String found() {
    return found;
  }
}
