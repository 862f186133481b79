package org.maestro.launch;

import com.fasterxml.jackson.databind.node.ArrayNode;
import jade.lang.acl.ACLMessage;
import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.ontology.home.WordList;
import org.maestro.platform.JoinedContainer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
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
  @Mixin private PlatformOptions platform;

  @Parameters(
      arity = "0..1",
      paramLabel = "HOME.ttl",
      completionCandidates = Shipped.Homes.class,
      description = "A home file, or a shipped home: bob, arena; without: the running platform.")
  private Optional<String> home = Optional.empty();

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    List<WordList.Entry> words =
        home.map(Shipped::home).map(WordList::of).orElseGet(this::ofThePlatform);
    PrintWriter out = spec.commandLine().getOut();
    if (json) {
      out.println(document(words));
    } else {
      new Table(
              COLUMNS,
              words.stream()
                  .map(word -> List.of(word.kind(), word.form(), word.meaning()))
                  .toList())
          .print(out);
    }
    return ExitCode.DONE;
  }

  private static String document(List<WordList.Entry> words) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode array = document.node().putArray("words");
    for (WordList.Entry word : words) {
      JsonMembers row =
          JsonMembers.in(array)
              .text("kind", word.kind())
              .text("word", word.name())
              .text("form", word.form());
      ArrayNode arguments = row.node().putArray("arguments");
      word.arguments()
          .forEach(
              argument ->
                  JsonMembers.in(arguments)
                      .text("variable", argument.name())
                      .text("class", argument.className()));
      row.text("meaning", word.meaning())
          .text("unit", word.unit())
          .words("devices", word.devices());
    }
    return document.toString();
  }

  private List<WordList.Entry> ofThePlatform() {
    try (JoinedContainer container = platform.join()) {
      ACLMessage reply =
          container.ask(
              ACLMessage.QUERY_REF,
              AgentNames.KNOWLEDGE,
              Words.content("query-ref", Words.named("words", List.of())));
      return Reply.lines(reply).stream()
          .map(
              line ->
                  new WordList.Entry(
                      line.string("kind").orElse(""),
                      line.string("form").orElse(""),
                      line.string("meaning").orElse(""),
                      line.string("unit").orElse(""),
                      line.find("devices").map(Words::terms).orElse(List.of()).stream()
                          .map(Words::plain)
                          .toList()))
          .toList();
    }
  }
}
