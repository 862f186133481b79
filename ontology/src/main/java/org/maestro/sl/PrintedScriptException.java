package org.maestro.sl;

/** A text is no script as ADE's are printed. The message is one sentence with the line. */
public final class PrintedScriptException extends IllegalArgumentException {

  private static final long serialVersionUID = 1L;

  private final int line;
  private final String problem;
  private final String cure;

  /**
   * @param line in the text, from 1
   * @param problem what is wrong there, read after the line
   * @param cure what would be right
   */
  public PrintedScriptException(int line, String problem, String cure) {
    super("Line " + line + " " + problem + "; " + cure + ".");
    this.line = line;
    this.problem = problem;
    this.cure = cure;
  }

  public int line() {
    return line;
  }

  public String problem() {
    return problem;
  }

  public String cure() {
    return cure;
  }
}
