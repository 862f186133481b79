package org.maestro.launch;

import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import picocli.CommandLine;

/**
 * The {@code plan} command alone, for a fast start: of the platform, its agents and its knowledge
 * no class is loaded.
 */
public final class PlanProgram {
  private PlanProgram() {}

  /** The entry point; the arguments are those after {@code plan}. */
  public static void main(String[] arguments) {
    Failures failures = new Failures();
    CommandLine commandLine =
        new CommandLine(new PlanCommand())
            .setOut(new PrintWriter(System.out, false, StandardCharsets.UTF_8))
            .setErr(new PrintWriter(System.err, true, StandardCharsets.UTF_8))
            .setExecutionExceptionHandler(failures)
            .setParameterExceptionHandler(failures);
    int exitCode = commandLine.execute(arguments);
    commandLine.getOut().flush();
    System.exit(exitCode);
  }
}
