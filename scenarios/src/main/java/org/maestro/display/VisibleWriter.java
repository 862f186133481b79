package org.maestro.display;

import java.io.BufferedWriter;
import java.io.FilterWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;

/** A terminal's writer: lines and tabs pass, all else that a terminal obeys is shown. */
public final class VisibleWriter extends FilterWriter {
  private VisibleWriter(Writer out) {
    super(out);
  }

  /**
   * Prints in UTF-8.
   *
   * @param atEachLine whether what was printed goes out at the end of each line
   */
  public static PrintWriter on(OutputStream out, boolean atEachLine) {
    return new PrintWriter(
        new BufferedWriter(new VisibleWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8))),
        atEachLine);
  }

  @Override
  public void write(int character) throws IOException {
    write(String.valueOf((char) character));
  }

  @Override
  public void write(char[] characters, int from, int length) throws IOException {
    out.write(VisibleText.lines(new String(characters, from, length)));
  }

  @Override
  public void write(String text, int from, int length) throws IOException {
    out.write(VisibleText.lines(text.substring(from, from + length)));
  }
}
