package org.maestro.launch;

import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** A script by which a shell completes the commands and options of {@code maestro}. */
@Command(
    name = "completion",
    description =
        "Print a script by which the shell completes commands, options and names as one types.",
    footer = {
      "",
      "bash: source <(./maestro completion bash)",
      "zsh: source <(./maestro completion zsh)",
      "fish: ./maestro completion fish | source"
    })
final class CompletionCommand implements Callable<Integer> {
  private static final String PROGRAM = "maestro";

  /** A shell that completes. */
  enum Shell {
    BASH,
    ZSH,
    FISH;

    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  @Spec private CommandSpec spec;

  @Parameters(paramLabel = "SHELL", description = "${COMPLETION-CANDIDATES}.")
  private Shell shell;

  @Override
  public Integer call() {
    CommandLine maestro = spec.commandLine().getParent();
    String script =
        switch (shell) {
          // Zsh takes bash's own, which says how.
          case BASH, ZSH -> AutoComplete.bash(PROGRAM, maestro);
          case FISH -> FishCompletion.of(PROGRAM, maestro.getCommandSpec());
        };
    script.strip().lines().forEach(spec.commandLine().getOut()::println);
    return ExitCode.DONE;
  }
}
