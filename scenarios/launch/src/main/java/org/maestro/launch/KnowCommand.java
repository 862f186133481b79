package org.maestro.launch;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
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
import org.maestro.sl.Term;
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
              if (!first.complete(answers)) {
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
    ObjectNode document = new ObjectMapper().createObjectNode();
    ArrayNode array = document.putArray("answers");
    for (Words answer : answers) {
      ObjectNode node = array.addObject();
      node.put("truth", answer.string("truth").orElse("unknown"));
      ObjectNode binding = node.putObject("binding");
      answer
          .termsOf("binding")
          .forEach(
              (variable, term) -> {
                if (term instanceof Term.Number number) {
                  binding.put(variable, number.value());
                } else if (term instanceof Term.Truth truth) {
                  binding.put(variable, truth.value());
                } else {
                  binding.put(variable, Words.plain(term));
                }
              });
      if (answer.term("age").isPresent()) {
        node.put("age_s", answer.number("age", 0));
      } else {
        node.putNull("age_s");
      }
      node.put(
          "source",
          answer.find("because").flatMap(because -> because.string("source")).orElse(null));
    }
    return document.toString();
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
