package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.maestro.ontology.home.Home;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Shows the words in which goals and questions can be put. */
@Command(
    name = "words",
    description =
        "List what goals can be about: predicates, numbers, places, things, devices, features; of a"
            + " running platform, with what its devices brought, or of a home.")
final class WordsCommand implements Callable<Integer> {
  private static final List<String> COLUMNS = List.of("kind", "word", "meaning");

  @Spec private CommandSpec spec;
  @Mixin private HomeWords words;

  @Option(
      names = "--language",
      arity = "0..1",
      paramLabel = "TAG",
      fallbackValue = "",
      description =
          "List how all in a home is called by people, in a language: en, de, or a grammar's file;"
              + " that of the home unless stated. With a home.")
  private Optional<String> language = Optional.empty();

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    PrintWriter out = spec.commandLine().getOut();
    if (language.isPresent()) {
      if (json) {
        throw CommandException.badInput("--language prints no JSON; leave --json out.");
      }
      printLexicon(out);
      return ExitCode.DONE;
    }
    JsonNode document = words.document();
    if (json) {
      out.println(document);
    } else {
      new Table(
              COLUMNS,
              JsonRows.of(
                  document.path("words"),
                  word ->
                      List.of(
                          word.path("kind").asText(""),
                          word.path("form").asText(""),
                          word.path("meaning").asText(""))))
          .print(out);
    }
    return ExitCode.DONE;
  }

  private void printLexicon(PrintWriter out) {
    List<List<String>> rows = new ArrayList<>();
    Home home = words.home();
    SpokenLanguage.of(home, language.filter(tag -> !tag.isEmpty()), Optional.empty())
        .lexicon()
        .listed()
        .forEach(
            (category, entries) ->
                entries.forEach(
                    (called, meanings) ->
                        rows.add(List.of(category, called, String.join(" or ", meanings)))));
    new Table(List.of("category", "words", "meaning"), rows).print(out);
  }
}
