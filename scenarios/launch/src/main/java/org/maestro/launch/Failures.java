package org.maestro.launch;

import java.io.PrintWriter;
import java.util.Objects;
import java.util.Optional;
import org.maestro.console.questions.RefusalException;
import org.maestro.deployment.DeploymentException;
import org.maestro.device.tasks.DeviceSetupException;
import org.maestro.experiment.setting.SettingException;
import org.maestro.ontology.home.HomeFaultException;
import org.maestro.ontology.validation.Nearest;
import org.maestro.sim.scene.SimulationException;
import org.maestro.sl.SlSyntaxException;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/**
 * Turns what went wrong into one sentence on stderr and an exit code; {@code --debug} adds the
 * stack trace.
 */
final class Failures implements IExecutionExceptionHandler, IParameterExceptionHandler {

  @Override
  public int handleExecutionException(Exception failure, CommandLine command, ParseResult parsed) {
    boolean debug =
        parsed.hasMatchedOption("--debug")
            || command.getParseResult() != null
                && command.getParseResult().hasMatchedOption("--debug");
    report(failure, command, debug);
    return exitCode(failure);
  }

  @Override
  public int handleParseException(ParameterException failure, String[] arguments) {
    CommandLine command = failure.getCommandLine();
    PrintWriter err = command.getErr();
    Optional<String> unknown = unknownCommand(failure);
    if (unknown.isPresent()) {
      err.println("maestro: " + unknown.get());
      return ExitCode.BAD_INPUT;
    }
    String sentence = wording(failure);
    err.println("maestro: " + sentence + (sentence.endsWith(".") ? "" : "."));
    if (!UnmatchedArgumentException.printSuggestions(failure, err)) {
      err.println("Try: ./" + command.getCommandSpec().qualifiedName() + " --help");
    }
    return ExitCode.BAD_INPUT;
  }

  private static Optional<String> unknownCommand(ParameterException failure) {
    CommandLine command = failure.getCommandLine();
    if (!(failure instanceof UnmatchedArgumentException unmatched) || command.getParent() != null) {
      return Optional.empty();
    }
    return Optional.of(noCommand(unmatched.getUnmatched().get(0), command));
  }

  /** That there is no command of that name, and what to do. */
  static String noCommand(String name, CommandLine maestro) {
    String cure =
        Nearest.cure(
            name, maestro.getSubcommands().keySet(), "./maestro --help lists those there are");
    return "There is no command %s; %s.".formatted(name, cure);
  }

  private static String wording(ParameterException failure) {
    return Objects.requireNonNullElse(failure.getMessage(), failure.toString())
        .replaceAll(" is not an? (int|long)$", " is no whole number that fits");
  }

  private static void report(Exception failure, CommandLine command, boolean debug) {
    PrintWriter err = command.getErr();
    err.println("maestro: " + sentence(failure));
    if (debug) {
      failure.printStackTrace(err);
    }
    err.flush();
  }

  static String sentence(Exception failure) {
    String message = failure.getMessage();
    if (message == null || message.isBlank()) {
      return failure.getClass().getSimpleName() + "; --debug shows where.";
    }
    return message.strip().replaceAll("\\s*\\R\\s*", " ");
  }

  /** Of what no program reckons with. */
  static String sentence(Error failure) {
    return failure instanceof OutOfMemoryError
        ? "The memory of this process does not suffice (%s)."
            .formatted(Objects.requireNonNullElse(failure.getMessage(), "no more is known"))
        : "The program itself is at fault (%s); the log says where.".formatted(failure);
  }

  static int exitCode(Exception failure) {
    if (failure instanceof CommandException own) {
      return own.exitCode();
    }
    boolean badInput =
        failure instanceof RefusalException refusal
                && refusal.kind() != RefusalException.Kind.OUTSIDE
            || failure instanceof HomeFaultException
            || failure instanceof SimulationException
            || failure instanceof DeviceSetupException
            || failure instanceof SettingException
            || failure instanceof DeploymentException
            || failure instanceof SlSyntaxException;
    return badInput ? ExitCode.BAD_INPUT : ExitCode.OUTSIDE;
  }
}
