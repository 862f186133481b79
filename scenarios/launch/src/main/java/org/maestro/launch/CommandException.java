package org.maestro.launch;

import java.util.Objects;
import org.maestro.console.questions.RefusalException;

/** A command cannot do what it was asked; the message is one sentence for its user. */
final class CommandException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final int exitCode;

  private CommandException(int exitCode, String sentence) {
    super(sentence);
    this.exitCode = exitCode;
  }

  private CommandException(int exitCode, String sentence, Throwable cause) {
    super(sentence, cause);
    this.exitCode = exitCode;
  }

  static CommandException badInput(String sentence) {
    return new CommandException(ExitCode.BAD_INPUT, sentence);
  }

  /** What is wrong with the input is told by what came of it. */
  static CommandException badInput(Throwable fault) {
    return badInput(Objects.requireNonNullElse(fault.getMessage(), fault.toString()));
  }

  static CommandException outside(String sentence) {
    return new CommandException(ExitCode.OUTSIDE, sentence);
  }

  static CommandException outside(String sentence, Throwable cause) {
    return new CommandException(ExitCode.OUTSIDE, sentence, cause);
  }

  /** What a platform did not answer. */
  static CommandException of(RefusalException refusal) {
    return new CommandException(
        refusal.kind() == RefusalException.Kind.OUTSIDE ? ExitCode.OUTSIDE : ExitCode.BAD_INPUT,
        Objects.requireNonNullElse(refusal.getMessage(), refusal.toString()),
        refusal);
  }

  int exitCode() {
    return exitCode;
  }
}
