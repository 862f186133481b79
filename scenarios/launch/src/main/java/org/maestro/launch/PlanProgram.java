package org.maestro.launch;

import java.io.PrintWriter;
import org.maestro.display.VisibleWriter;
import picocli.CommandLine;

/**
 * The {@code plan} command alone, for a fast start: of the platform, its agents and its knowledge
 * no class is loaded.
 */
public final class PlanProgram {
  private PlanProgram() {}

  /** The entry point; the arguments are those after {@code plan}. */
  public static void main(String[] arguments) {
    PrintWriter out = VisibleWriter.on(System.out, false);
    PrintWriter err = VisibleWriter.on(System.err, true);
    int exitCode =
        PddlSolving.Asked.plain(arguments)
            .map(asked -> solve(new PddlSolving(asked, out, err), err))
            .orElseGet(() -> command(out, err).execute(arguments));
    out.flush();
    System.exit(exitCode);
  }

  private static int solve(PddlSolving solving, PrintWriter err) {
    try {
      return solving.solve();
    } catch (RuntimeException e) {
      err.println("maestro: " + Failures.sentence(e));
      return Failures.exitCode(e);
    }
  }

  private static CommandLine command(PrintWriter out, PrintWriter err) {
    Failures failures = new Failures();
    return new CommandLine(new PlanCommand())
        .setOut(out)
        .setErr(err)
        .setExecutionExceptionHandler(failures)
        .setParameterExceptionHandler(failures);
  }
}
