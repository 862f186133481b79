package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import java.util.stream.Stream;
import org.maestro.console.questions.Questions;
import org.maestro.text.VisibleText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Shows what a platform's tables hold: its agents, or its containers; or draws the agents. */
@Command(
    name = "agents",
    description =
        "List the agents of a running platform, and their members; or its containers; or draw which agent turns to which.")
final class AgentsCommand implements Callable<Integer> {
  private static final List<String> AGENTS =
      List.of(
          "agent",
          "container",
          "members",
          "phase",
          "state",
          "disabled",
          "life",
          "since",
          "services");
  private static final List<String> LAYERS =
      List.of(
          "control: agent", "container", "domain: member", "phase", "state", "hardware: driver");
  private static final List<String> CONTAINERS =
      List.of(
          "container", "process", "topics", "provides", "since", "address", "machine", "agents");
  private static final String WHY = "why";
  private static final int MINUTE = 60;
  private static final int HOUR = 3600;

  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Option(
      names = "--containers",
      description = "The container table, with the agents of each container.")
  private boolean containers;

  @Option(
      names = "--layers",
      description =
          "The three layers of each agent: itself, the members that it stands for, and the drivers"
              + " of their hardware.")
  private boolean layers;

  @Option(
      names = "--diagram",
      description =
          "A diagram of the running agents, in the notation of Mermaid: what each is for, and which turns to which.")
  private boolean diagram;

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    if (Stream.of(containers, layers, diagram).filter(asked -> asked).count() > 1) {
      throw CommandException.badInput(
          "--containers, --layers and --diagram each show something else; give one of them.");
    }
    try (AskedPlatform asked = platform.ask()) {
      JsonNode document = asked.answer(question());
      PrintWriter out = spec.commandLine().getOut();
      if (json) {
        out.println(document);
      } else if (diagram) {
        new MermaidDiagram(document).print(out);
      } else if (containers) {
        new Table(CONTAINERS, JsonRows.of(document.path("containers"), AgentsCommand::container))
            .print(out);
      } else if (layers) {
        new Table(LAYERS, layers(document)).print(out);
      } else {
        new Table(AGENTS, JsonRows.of(document.path("agents"), AgentsCommand::agent)).print(out);
        document.path("agents").forEach(agent -> printWhy(agent, out));
      }
      return ExitCode.DONE;
    }
  }

  private Function<Questions, CompletableFuture<JsonNode>> question() {
    if (diagram) {
      return Questions::references;
    }
    return containers ? Questions::containers : Questions::agents;
  }

  private static void printWhy(JsonNode agent, PrintWriter out) {
    if (agent.path(WHY).isTextual()) {
      out.println(
          VisibleText.line(
              JsonRows.words(agent, "members") + " is refused: " + agent.path(WHY).asText()));
    }
  }

  /** Members that are there and cannot be used as they describe themselves. */
  static List<String> refused(JsonNode agents) {
    return JsonRows.of(agents.path("agents"), agent -> agent).stream()
        .filter(agent -> agent.path(WHY).isTextual())
        .flatMap(agent -> JsonRows.of(agent.path("members"), JsonNode::asText).stream())
        .toList();
  }

  private static List<String> agent(JsonNode agent) {
    return List.of(
        JsonRows.text(agent, "agent"),
        JsonRows.text(agent, "container"),
        JsonRows.words(agent, "members"),
        JsonRows.text(agent, "phase"),
        JsonRows.text(agent, "state"),
        JsonRows.words(agent, "disabled"),
        JsonRows.text(agent, "life"),
        since(agent),
        JsonRows.words(agent, "services"));
  }

  /** A row for each member that an agent stands for (Three-layered architecture, 3; M1). */
  static List<List<String>> layers(JsonNode document) {
    List<List<String>> rows = new ArrayList<>();
    document
        .path("agents")
        .forEach(
            agent -> {
              for (int member = 0; member < agent.path("members").size(); member++) {
                String driver = agent.path("drivers").path(member).asText();
                rows.add(
                    List.of(
                        JsonRows.text(agent, "agent"),
                        JsonRows.text(agent, "container"),
                        agent.path("members").path(member).asText(),
                        JsonRows.text(agent, "phase"),
                        JsonRows.text(agent, "state"),
                        driver.isEmpty() ? "-" : driver));
              }
            });
    return rows;
  }

  private static List<String> container(JsonNode container) {
    return List.of(
        JsonRows.text(container, "container"),
        JsonRows.text(container, "process"),
        JsonRows.words(container, "topics"),
        JsonRows.words(container, "provides"),
        since(container),
        JsonRows.text(container, "address"),
        machine(container),
        JsonRows.words(container, "agents"));
  }

  private static String machine(JsonNode container) {
    return container.path("pid").isNumber()
        ? JsonRows.text(container, "machine") + " pid " + container.path("pid").asText()
        : "-";
  }

  private static String since(JsonNode row) {
    long seconds = Math.round(row.path("age_s").asDouble());
    if (seconds < MINUTE) {
      return seconds + " s";
    }
    return seconds < HOUR
        ? seconds / MINUTE + " min " + seconds % MINUTE + " s"
        : seconds / HOUR + " h " + seconds % HOUR / MINUTE + " min";
  }
}
