package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Tells of a resident's day in the home of a running platform (ADE, 5; A70). */
@Command(
    name = "day",
    description =
        "Tell of a person's day in the home: where she was, what devices were at, and what was"
            + " asked for.")
final class DayCommand implements Callable<Integer> {
  private static final List<String> COLUMNS = List.of("from", "to", "what was so");

  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Parameters(paramLabel = "PERSON", description = "Her name in the home, such as Bob.")
  private String person;

  @Option(
      names = "--date",
      paramLabel = "DATE",
      description =
          "By the home's clocks, such as 2026-01-31; usually the day that it is. Earlier days are"
              + " kept where the platform runs with --data.")
  private Optional<String> date = Optional.empty();

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    try (AskedPlatform asked = platform.ask()) {
      JsonNode document = asked.answer(questions -> questions.day(person, date));
      PrintWriter out = spec.commandLine().getOut();
      if (json) {
        out.println(document);
      } else {
        out.println(
            "%s, %s".formatted(document.path("person").asText(), document.path("date").asText()));
        new Table(COLUMNS, JsonRows.of(document.path("told"), DayCommand::row)).print(out);
        int leftOut = document.path("left_out").asInt();
        if (leftOut > 0) {
          out.println("Left out, as it is private: %d".formatted(leftOut));
        }
      }
      return ExitCode.DONE;
    }
  }

  private static List<String> row(JsonNode told) {
    return List.of(
        JsonRows.text(told, "from"), told.path("to").asText(""), JsonRows.text(told, "text"));
  }
}
