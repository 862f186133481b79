package org.maestro.launch;

/** A command cannot do what it was asked; the message is one sentence for its user. */
final class CommandException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final int exitCode;

  private CommandException(int exitCode, String sentence, Throwable cause) {
    super(sentence, cause);
    this.exitCode = exitCode;
  }

  static CommandException badInput(String sentence) {
    return new CommandException(ExitCode.BAD_INPUT, sentence, null);
  }

  static CommandException outside(String sentence) {
    return new CommandException(ExitCode.OUTSIDE, sentence, null);
  }

  static CommandException outside(String sentence, Throwable cause) {
    return new CommandException(ExitCode.OUTSIDE, sentence, cause);
  }

  int exitCode() {
    return exitCode;
  }
}
