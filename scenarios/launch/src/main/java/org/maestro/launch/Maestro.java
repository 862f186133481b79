package org.maestro.launch;

import java.io.PrintStream;
import java.util.Locale;
import java.util.Objects;
import org.maestro.display.VisibleWriter;
import org.maestro.text.VisibleText;
import org.slf4j.bridge.SLF4JBridgeHandler;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** The {@code maestro} command. */
@Command(
    name = "maestro",
    synopsisSubcommandLabel = "COMMAND",
    versionProvider = Version.class,
    description = "Orchestrates service robots and the rooms they work in.",
    subcommands = {
      DemoCommand.class,
      RunCommand.class,
      ContainerCommand.class,
      DevicesCommand.class,
      DeviceCommand.class,
      ZigbeeCommand.class,
      GoalCommand.class,
      RunScriptCommand.class,
      ScriptsCommand.class,
      AgentCommand.class,
      AgentsCommand.class,
      GoalsCommand.class,
      KnowCommand.class,
      WordsCommand.class,
      RoomsCommand.class,
      UnderstandCommand.class,
      SayCommand.class,
      ChatCommand.class,
      SlCommand.class,
      WhyCommand.class,
      TraceCommand.class,
      DayCommand.class,
      LogCommand.class,
      AnswerCommand.class,
      AnswersCommand.class,
      CancelCommand.class,
      StopCommand.class,
      ReviveCommand.class,
      CheckCommand.class,
      NewCommand.class,
      PlanCommand.class,
      SecureCommand.class,
      BenchCommand.class,
      ExperimentCommand.class,
      CompletionCommand.class,
      HelpCommand.class
    },
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:done",
      "1:goal not reached, or faults found",
      "2:bad input or usage",
      "3:something outside failed (port, broker, display, disk)",
      "4:goal reached as far as is known, but nobody could confirm it"
    },
    footer = {
      "",
      "Start with: ./maestro demo",
      "What commands print with --json is described in docs/schemas."
    })
public final class Maestro implements Runnable {
  @Spec private CommandSpec spec;

  @Option(
      names = {"-h", "--help"},
      usageHelp = true,
      scope = ScopeType.INHERIT,
      description = "Show this help.")
  @SuppressWarnings("UnusedVariable") // picocli shows the help by itself
  private boolean help;

  @Option(names = "--version", versionHelp = true, description = "Show which MAESTRO this is.")
  @SuppressWarnings("UnusedVariable") // picocli shows the version by itself
  private boolean version;

  @Option(
      names = "--debug",
      scope = ScopeType.INHERIT,
      description = "Show the stack trace of a failure.")
  @SuppressWarnings("UnusedVariable") // whoever tells a failure asks for it by its name
  private boolean debug;

  /** The entry point; ends the process, as JADE leaves threads behind. */
  public static void main(String[] arguments) {
    // What is told is English, and read by programs: numbers have points, whatever people set.
    Locale.setDefault(Locale.Category.FORMAT, Locale.ROOT);
    try {
      RuntimeDirectory.ofUser().prepareLog();
    } catch (CommandException e) {
      System.err.println(
          "maestro: " + VisibleText.line(Objects.requireNonNullElse(e.getMessage(), e.toString())));
      System.exit(e.exitCode());
    }
    SLF4JBridgeHandler.removeHandlersForRootLogger();
    SLF4JBridgeHandler.install();
    PrintStream out = System.out;
    PrintStream people = System.err;
    // Before the command line is made: picocli goes back to plain writers when these change later.
    System.setOut(StrayOutput.before(people));
    System.setErr(StrayOutput.before(people));
    System.exit(commandLine(out, people).execute(arguments));
  }

  static CommandLine commandLine(PrintStream out, PrintStream err) {
    Failures failures = new Failures();
    return new CommandLine(new Maestro())
        .setOut(VisibleWriter.on(out, true))
        .setErr(VisibleWriter.on(err, true))
        .setCaseInsensitiveEnumValuesAllowed(true)
        .setUsageHelpAutoWidth(true)
        .setExecutionExceptionHandler(failures)
        .setParameterExceptionHandler(failures);
  }

  @Override
  public void run() {
    throw new ParameterException(
        spec.commandLine(), "A command is missing; ./maestro demo shows the main job.");
  }
}
