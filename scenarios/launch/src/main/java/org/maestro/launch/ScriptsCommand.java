package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import org.maestro.ontology.home.WordList;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Lists the scripts of a home. */
@Command(
    name = "scripts",
    description = "List the scripts of a running platform's home, or of a home, and their worth.")
final class ScriptsCommand implements Callable<Integer> {
  private static final List<String> COLUMNS = List.of("script", "what it does");

  @Spec private CommandSpec spec;
  @Mixin private HomeWords words;

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    JsonNode document = words.document();
    ArrayNode scripts = JsonNodeFactory.instance.arrayNode();
    document
        .path("words")
        .forEach(
            word -> {
              if (word.path("kind").asText().equals(WordList.SCRIPT)) {
                scripts.add(word);
              }
            });
    PrintWriter out = spec.commandLine().getOut();
    if (json) {
      ObjectNode listed = document.deepCopy();
      listed.set("words", scripts);
      out.println(listed);
    } else if (scripts.isEmpty()) {
      out.println("This home has no scripts; docs/guide-scripts.md tells how one is written.");
    } else {
      new Table(
              COLUMNS,
              JsonRows.of(
                  scripts,
                  script ->
                      List.of(script.path("form").asText(""), script.path("meaning").asText(""))))
          .print(out);
    }
    return ExitCode.DONE;
  }
}
