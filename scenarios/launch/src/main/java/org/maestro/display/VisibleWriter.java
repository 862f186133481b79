package org.maestro.display;

import java.io.BufferedWriter;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import org.maestro.text.VisibleText;

/**
 * A terminal's writer: lines and tabs pass, all else that a terminal obeys is shown. What is
 * printed with {@code println}, and each text that a format takes, is part of one line: a line
 * break in it is shown too, so that nobody's words begin a line of their own.
 */
public final class VisibleWriter extends PrintWriter {
  private VisibleWriter(Writer out, boolean atEachLine) {
    super(out, atEachLine);
  }

  /**
   * Prints in UTF-8.
   *
   * @param atEachLine whether what was printed goes out at the end of each line
   */
  public static PrintWriter on(OutputStream out, boolean atEachLine) {
    return new VisibleWriter(
        new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8)), atEachLine);
  }

  @Override
  public void println(String text) {
    super.println(VisibleText.line(String.valueOf(text)));
  }

  @Override
  public PrintWriter format(String format, Object... parts) {
    return super.format(format, visible(parts));
  }

  @Override
  public PrintWriter format(Locale locale, String format, Object... parts) {
    return super.format(locale, format, visible(parts));
  }

  private static Object[] visible(Object... parts) {
    return Arrays.stream(parts)
        .map(part -> part instanceof String text ? VisibleText.line(text) : part)
        .toArray();
  }

  @Override
  public void write(int character) {
    write(String.valueOf((char) character));
  }

  @Override
  public void write(char[] characters, int from, int length) {
    write(new String(characters, from, length));
  }

  @Override
  public void write(String text, int from, int length) {
    String visible = VisibleText.lines(text.substring(from, from + length));
    super.write(visible, 0, visible.length());
  }
}
