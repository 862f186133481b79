package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.maestro.console.documents.GivenAnswersDocument;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Lists what people have answered to scripts of a running platform (ADE, 3.3; A45). */
@Command(
    name = "answers",
    description = "List what people have answered to questions of scripts of the running platform.")
final class AnswersCommand implements Callable<Integer> {
  private static final List<String> COLUMNS =
      List.of("at", "person", "question", "answer", "part of");

  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Parameters(
      arity = "0..1",
      paramLabel = "SCRIPT",
      description = "Only what was answered to the script of that name.")
  private Optional<String> script = Optional.empty();

  @ArgGroup private Form form = new Form();

  /** How it is printed. */
  static final class Form {
    @Option(
        names = "--csv",
        description = "Print comma-separated values, a record for each answer.")
    private boolean csv;

    @Option(names = "--json", description = "Print one JSON document.")
    private boolean json;
  }

  @Override
  public Integer call() {
    try (AskedPlatform asked = platform.ask()) {
      JsonNode document = asked.answer(questions -> questions.answers(script));
      PrintWriter out = spec.commandLine().getOut();
      if (form.json) {
        out.println(document);
      } else if (form.csv) {
        GivenAnswersDocument.csv(document).lines().forEach(out::println);
      } else if (document.path("answers").isEmpty()) {
        out.println(
            script
                .map(name -> "Nobody has answered anything to a script named " + name + " yet.")
                .orElse("Nobody has answered anything to a script yet."));
      } else {
        new Table(COLUMNS, JsonRows.of(document.path("answers"), AnswersCommand::row)).print(out);
      }
      return ExitCode.DONE;
    }
  }

  private static List<String> row(JsonNode answer) {
    return List.of(
        JsonRows.text(answer, "at"),
        JsonRows.text(answer, "person"),
        JsonRows.text(answer, "question"),
        JsonRows.text(answer, "answer"),
        JsonRows.text(answer, "script") + ", " + JsonRows.text(answer, "part"));
  }
}
