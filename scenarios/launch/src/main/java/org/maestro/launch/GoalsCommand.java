package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.maestro.console.questions.Questions;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Lists a platform's goals. */
@Command(name = "goals", description = "List the goals of a running platform.")
final class GoalsCommand implements Callable<Integer> {
  private static final List<String> COLUMNS =
      List.of(
          "id", "goal", "requester", "state", "priority", "deadline", "age", "waits for", "detail");

  private static final List<String> WORTH_COLUMNS =
      List.of("id", "goal", "state", "priority", "u·g", "u = p·b − c", "g", "detail");

  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Option(
      names = "--worth",
      description = "Tell what each is worth, and the numbers that this comes from.")
  private boolean worth;

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    try (AskedPlatform asked = platform.ask()) {
      JsonNode document = asked.answer(Questions::goals);
      PrintWriter out = spec.commandLine().getOut();
      JsonNode goals = document.path("goals");
      if (json) {
        out.println(document);
      } else if (goals.isEmpty()) {
        out.println("No goal was stated yet; try ./maestro goal \"(nextTo Cup Bob)\"");
      } else {
        (worth
                ? new Table(WORTH_COLUMNS, JsonRows.of(goals, WorthRow::of))
                : new Table(COLUMNS, JsonRows.of(goals, GoalsCommand::row)))
            .print(out);
      }
      return ExitCode.DONE;
    }
  }

  private static List<String> row(JsonNode goal) {
    return List.of(
        JsonRows.text(goal, "id"),
        JsonRows.text(goal, "goal"),
        JsonRows.text(goal, "requester"),
        JsonRows.text(goal, "state"),
        goal.path("priority").asText(),
        seconds(goal, "deadline_s"),
        seconds(goal, "age_s"),
        waits(goal.path("waits")),
        goal.path("detail").asText(""));
  }

  private static String seconds(JsonNode goal, String name) {
    return goal.path(name).isNumber()
        ? String.format(Locale.ROOT, "%.1f s", goal.path(name).asDouble())
        : "-";
  }

  private static String waits(JsonNode waits) {
    return waits.isEmpty()
        ? "-"
        : JsonRows.of(
                waits,
                wait -> wait.path("for").asText() + " (" + wait.path("holder").asText() + ")")
            .stream()
            .distinct()
            .collect(Collectors.joining(", "));
  }
}
