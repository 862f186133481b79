package org.maestro.launch;

import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.maestro.display.VisibleWriter;
import org.maestro.text.VisibleText;
import org.slf4j.LoggerFactory;
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
  /** The commands by their names, in the order of the help. */
  private static final List<Map.Entry<String, Class<?>>> COMMANDS =
      List.of(
          Map.entry("demo", DemoCommand.class),
          Map.entry("run", RunCommand.class),
          Map.entry("container", ContainerCommand.class),
          Map.entry("devices", DevicesCommand.class),
          Map.entry("device", DeviceCommand.class),
          Map.entry("zigbee", ZigbeeCommand.class),
          Map.entry("player", PlayerCommand.class),
          Map.entry("stream", StreamCommand.class),
          Map.entry("ros", RosCommand.class),
          Map.entry("goal", GoalCommand.class),
          Map.entry("run-script", RunScriptCommand.class),
          Map.entry("scripts", ScriptsCommand.class),
          Map.entry("agent", AgentCommand.class),
          Map.entry("agents", AgentsCommand.class),
          Map.entry("goals", GoalsCommand.class),
          Map.entry("know", KnowCommand.class),
          Map.entry("words", WordsCommand.class),
          Map.entry("rooms", RoomsCommand.class),
          Map.entry("understand", UnderstandCommand.class),
          Map.entry("say", SayCommand.class),
          Map.entry("chat", ChatCommand.class),
          Map.entry("sl", SlCommand.class),
          Map.entry("why", WhyCommand.class),
          Map.entry("trace", TraceCommand.class),
          Map.entry("day", DayCommand.class),
          Map.entry("log", LogCommand.class),
          Map.entry("answer", AnswerCommand.class),
          Map.entry("answers", AnswersCommand.class),
          Map.entry("cancel", CancelCommand.class),
          Map.entry("stop", StopCommand.class),
          Map.entry("revive", ReviveCommand.class),
          Map.entry("check", CheckCommand.class),
          Map.entry("new", NewCommand.class),
          Map.entry("plan", PlanCommand.class),
          Map.entry("secure", SecureCommand.class),
          Map.entry("calibrate", CalibrateCommand.class),
          Map.entry("bench", BenchCommand.class),
          Map.entry("experiment", ExperimentCommand.class),
          Map.entry("completion", CompletionCommand.class),
          Map.entry("help", HelpCommand.class));

  /** Commands that print what others there are. */
  private static final Set<String> TELLS_OF_OTHERS = Set.of("help", "completion");

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
    System.exit(carriedOut(commandLine(out, people, named(arguments)), people, arguments));
  }

  /** What is no exception, such as that memory does not suffice, would be printed nowhere. */
  static int carriedOut(CommandLine line, PrintStream people, String... arguments) {
    try {
      return line.execute(arguments);
    } catch (Error failure) {
      people.println("maestro: " + VisibleText.line(Failures.sentence(failure)));
      LoggerFactory.getLogger(Maestro.class).error("The command ended by an error", failure);
      return ExitCode.OUTSIDE;
    }
  }

  /** The command that is named first; all where none is, so that the help tells of them. */
  private static List<Map.Entry<String, Class<?>>> named(String... arguments) {
    List<Map.Entry<String, Class<?>>> named =
        COMMANDS.stream()
            .filter(command -> arguments.length > 0 && command.getKey().equals(arguments[0]))
            .filter(command -> !TELLS_OF_OTHERS.contains(command.getKey()))
            .toList();
    return named.isEmpty() ? COMMANDS : named;
  }

  static CommandLine commandLine(PrintStream out, PrintStream err) {
    return commandLine(out, err, COMMANDS);
  }

  /** To make each command takes longer than most of them take to answer. */
  private static CommandLine commandLine(
      PrintStream out, PrintStream err, List<Map.Entry<String, Class<?>>> commands) {
    CommandLine line = new CommandLine(new Maestro());
    commands.forEach(command -> line.addSubcommand(command.getKey(), command.getValue()));
    Failures failures = new Failures();
    return line.setOut(VisibleWriter.on(out, true))
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
