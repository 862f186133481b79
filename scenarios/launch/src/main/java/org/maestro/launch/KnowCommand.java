package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.StringJoiner;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.maestro.agents.content.Words;
import org.maestro.console.documents.AnswersDocument;
import org.maestro.platform.JoinedContainer;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Asks a running platform what it knows, from an agent of this process. */
@Command(
    name = "know",
    description = "Ask a running platform what it knows, how surely, and how old.")
final class KnowCommand implements Callable<Integer> {
  private static final int ANSWERED_WITHIN_SECONDS = 30;
  private static final List<String> COLUMNS = List.of("truth", "binding", "age", "source");

  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Parameters(
      paramLabel = "QUESTION",
      description =
          "In MAESTRO-SL, such as \"(in Cup zone-b)\", or with variables \"(in Cup ?where)\".")
  private String question;

  @Option(names = "--follow", description = "Tell each change until Ctrl-C.")
  private boolean follows;

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() throws InterruptedException {
    Formula asked = SlParser.formula(question);
    if (follows) {
      follow(asked);
    } else {
      try (AskedPlatform known = platform.ask()) {
        print(known.answer(questions -> questions.know(question)));
      }
    }
    return ExitCode.DONE;
  }

  private void follow(Formula asked) throws InterruptedException {
    JoinedContainer container = platform.join();
    CompletableFuture<Void> first = new CompletableFuture<>();
    try {
      container
          .desk()
          .follow(
              asked,
              answers -> {
                print(AnswersDocument.of(answers.stream().map(Words::of).toList()));
                first.complete(null);
              },
              failure -> first.completeExceptionally(CommandException.badInput(failure)));
      first.get(ANSWERED_WITHIN_SECONDS, TimeUnit.SECONDS);
      UntilStopped.run(spec.commandLine().getOut(), "Changes follow.", container::close);
    } catch (ExecutionException e) {
      throw CommandException.badInput(Objects.requireNonNull(e.getCause()));
    } catch (TimeoutException e) {
      throw CommandException.outside("The knowledge agent does not answer.", e);
    } finally {
      container.close();
    }
  }

  private synchronized void print(JsonNode document) {
    PrintWriter out = spec.commandLine().getOut();
    if (json) {
      out.println(document);
    } else {
      new Table(COLUMNS, JsonRows.of(document.path("answers"), KnowCommand::row)).print(out);
    }
    out.flush();
  }

  /** Where it is not sure, with how likely it is. */
  private static String truth(JsonNode answer) {
    double confidence = answer.path("confidence").asDouble(1);
    String truth = JsonRows.text(answer, "truth");
    return confidence < 1 ? String.format(Locale.ROOT, "%s (%.2f)", truth, confidence) : truth;
  }

  private static List<String> row(JsonNode answer) {
    String origin = AnswersDocument.origin(answer);
    StringJoiner binding = new StringJoiner(", ");
    answer
        .path("binding")
        .properties()
        .forEach(
            bound -> binding.add("?" + bound.getKey() + " = " + JsonRows.plain(bound.getValue())));
    return List.of(
        truth(answer),
        binding.toString(),
        answer.path("age_s").isNumber()
            ? String.format(Locale.ROOT, "%.1f s", answer.path("age_s").asDouble())
            : "-",
        origin.isEmpty() ? "-" : origin);
  }
}
