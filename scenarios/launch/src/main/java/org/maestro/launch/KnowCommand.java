package org.maestro.launch;

import com.fasterxml.jackson.databind.node.ArrayNode;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Collectors;
import org.maestro.agents.content.Words;
import org.maestro.platform.JoinedContainer;
import org.maestro.sl.Content;
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
    JoinedContainer container = platform.join();
    CompletableFuture<List<Content>> first = new CompletableFuture<>();
    container
        .desk()
        .follow(
            asked,
            answers -> {
              if (!first.complete(answers) && follows) {
                print(answers);
              }
            },
            failure -> first.completeExceptionally(CommandException.badInput(failure)));
    try {
      print(first.get(ANSWERED_WITHIN_SECONDS, TimeUnit.SECONDS));
      if (follows) {
        UntilStopped.run(spec.commandLine().getOut(), "Changes follow.", container::close);
      }
      return ExitCode.DONE;
    } catch (ExecutionException e) {
      throw CommandException.badInput(Objects.requireNonNull(e.getCause()));
    } catch (TimeoutException e) {
      throw CommandException.outside("The knowledge agent does not answer.", e);
    } finally {
      container.close();
    }
  }

  private synchronized void print(List<Content> answers) {
    List<Words> lines = answers.stream().map(Words::of).toList();
    PrintWriter out = spec.commandLine().getOut();
    if (json) {
      out.println(document(lines));
    } else {
      new Table(COLUMNS, lines.stream().map(KnowCommand::row).toList()).print(out);
    }
    out.flush();
  }

  private static String document(List<Words> answers) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode array = document.node().putArray("answers");
    for (Words answer : answers) {
      String truth = answer.string("truth").orElse("unknown");
      JsonMembers row =
          JsonMembers.in(array)
              .text("truth", truth)
              .terms("binding", answer.termsOf("binding"))
              .number("age_s", answer, "age");
      if (truth.equals("unknown")) {
        row.number("confidence", OptionalDouble.empty());
      } else {
        row.number("confidence", answer, "confidence");
      }
      row.text("source", answer.find("because").flatMap(because -> because.string("source")));
      ArrayNode because = row.node().putArray("because");
      answer.all().stream()
          .filter(part -> part.name().equals("because"))
          .map(Words::of)
          .forEach(belief -> add(because, belief));
    }
    return document.toString();
  }

  private static void add(ArrayNode beliefs, Words belief) {
    JsonMembers.in(beliefs)
        .text("fact", belief.string("fact"))
        .text("source", belief.string("source"))
        .text("kind", belief.string("kind"))
        .text("since", belief.string("since"))
        .number("age_s", belief, "age")
        .number("confidence", belief, "confidence");
  }

  private static List<String> row(Words answer) {
    return List.of(
        answer.string("truth").orElse("-"),
        answer.termsOf("binding").entrySet().stream()
            .map(bound -> "?" + bound.getKey() + " = " + Words.plain(bound.getValue()))
            .collect(Collectors.joining(", ")),
        answer.term("age").isPresent()
            ? String.format(Locale.ROOT, "%.1f s", answer.number("age", 0))
            : "-",
        answer.find("because").flatMap(because -> because.string("source")).orElse("-"));
  }
}
