package org.maestro.launch;

import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Shows the same as {@code --help}; picocli's own has an option that is inherited here. */
@Command(name = "help", description = "Show this help, or that of a command.")
final class HelpCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Parameters(arity = "0..1", paramLabel = "COMMAND", description = "Of which help is wanted.")
  private Optional<String> command = Optional.empty();

  @Override
  public Integer call() {
    CommandLine maestro = spec.commandLine().getParent();
    command.map(name -> named(name, maestro)).orElse(maestro).usage(spec.commandLine().getOut());
    return ExitCode.DONE;
  }

  private static CommandLine named(String name, CommandLine maestro) {
    CommandLine found = maestro.getSubcommands().get(name);
    if (found == null) {
      throw CommandException.badInput(Failures.noCommand(name, maestro));
    }
    return found;
  }
}
