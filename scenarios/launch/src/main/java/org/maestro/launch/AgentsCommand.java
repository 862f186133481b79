package org.maestro.launch;

import com.fasterxml.jackson.databind.node.ArrayNode;
import jade.lang.acl.ACLMessage;
import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.platform.JoinedContainer;
import org.maestro.text.VisibleText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Shows what a platform's tables hold: its agents, or its containers. */
@Command(
    name = "agents",
    description = "List the agents of a running platform, and their members; or its containers.")
final class AgentsCommand implements Callable<Integer> {
  private static final List<String> AGENTS =
      List.of("agent", "container", "members", "phase", "state", "life", "since", "services");
  private static final List<String> CONTAINERS =
      List.of(
          "container", "process", "topics", "provides", "since", "address", "machine", "agents");
  private static final List<String> STARTS = List.of("directory", "command");
  private static final String WHY = "why";
  private static final int MINUTE = 60;
  private static final int HOUR = 3600;

  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Option(
      names = "--containers",
      description = "The container table, with the agents of each container.")
  private boolean containers;

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    try (JoinedContainer container = platform.join()) {
      List<Words> lines = tables(container);
      String own = container.name();
      List<Words> wanted =
          lines.stream()
              .filter(line -> line.string("place").isPresent() == containers)
              .filter(line -> !at(line).equals(own))
              .toList();
      PrintWriter out = spec.commandLine().getOut();
      if (json) {
        out.println(document(wanted));
      } else {
        new Table(
                containers ? CONTAINERS : AGENTS,
                wanted.stream().map(line -> containers ? place(line) : agent(line)).toList())
            .print(out);
        wanted.stream()
            .filter(line -> line.string(WHY).isPresent())
            .map(line -> all(line, "members") + " is refused: " + line.string(WHY).orElse(""))
            .forEach(sentence -> out.println(VisibleText.line(sentence)));
      }
      return ExitCode.DONE;
    }
  }

  private static List<Words> tables(JoinedContainer container) {
    return Reply.lines(
        container.ask(ACLMessage.QUERY_REF, AgentNames.SUPERVISOR, Words.content("query-ref")));
  }

  /** Members that are there and cannot be used as they describe themselves. */
  static List<String> refused(JoinedContainer container) {
    return tables(container).stream()
        .filter(line -> line.string(WHY).isPresent())
        .flatMap(line -> words(line, "members").stream())
        .toList();
  }

  private String document(List<Words> lines) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode array = document.node().putArray(containers ? "containers" : "agents");
    for (Words line : lines) {
      JsonMembers row = JsonMembers.in(array);
      if (containers) {
        container(row, line);
      } else {
        row.text("agent", line.string("agent"))
            .text("container", line.string("container"))
            .words("members", words(line, "members"))
            .text("phase", line.string("phase"))
            .text("state", line.string("state"))
            .text("life", line.string("life"))
            .words("services", words(line, "services"))
            .text(WHY, line.string(WHY));
      }
      row.text("since", line.string("since")).number("age_s", line, "age");
    }
    return document.toString();
  }

  private static void container(JsonMembers row, Words line) {
    Optional<Words> start = start(line);
    row.text("container", line.string("place"))
        .text("process", line.string("process"))
        .words("topics", words(line, "topics"))
        .words("provides", words(line, "provides"))
        .text("address", line.string("address"))
        .text("machine", start.flatMap(its -> its.string("machine")));
    start
        .flatMap(its -> its.string("pid"))
        .ifPresentOrElse(
            pid -> row.node().put("pid", Long.parseLong(pid)), () -> row.node().putNull("pid"));
    STARTS.forEach(part -> row.text(part, start.flatMap(its -> its.string(part))));
    row.words("agents", words(line, "holds"));
  }

  private static String at(Words line) {
    return line.string("place").or(() -> line.string("container")).orElse("");
  }

  private static List<String> agent(Words line) {
    return List.of(
        line.string("agent").orElse("-"),
        line.string("container").orElse("-"),
        all(line, "members"),
        line.string("phase").orElse("-"),
        line.string("state").orElse("-"),
        line.string("life").orElse("-"),
        since(line),
        all(line, "services"));
  }

  private static List<String> place(Words line) {
    return List.of(
        line.string("place").orElse("-"),
        line.string("process").orElse("-"),
        all(line, "topics"),
        all(line, "provides"),
        since(line),
        line.string("address").orElse("-"),
        machine(start(line)),
        all(line, "holds"));
  }

  private static Optional<Words> start(Words line) {
    return line.find("started").filter(its -> its.string("pid").isPresent());
  }

  private static String machine(Optional<Words> start) {
    return start
        .map(its -> its.string("machine").orElse("-") + " pid " + its.string("pid").orElse("-"))
        .orElse("-");
  }

  private static String all(Words line, String name) {
    List<String> words = words(line, name);
    return words.isEmpty() ? "-" : String.join(" ", words);
  }

  private static List<String> words(Words line, String name) {
    return line.find(name).map(Words::terms).orElse(List.of()).stream().map(Words::plain).toList();
  }

  private static String since(Words line) {
    long seconds = Math.round(line.number("age", 0));
    if (seconds < MINUTE) {
      return seconds + " s";
    }
    return seconds < HOUR
        ? seconds / MINUTE + " min " + seconds % MINUTE + " s"
        : seconds / HOUR + " h " + seconds % HOUR / MINUTE + " min";
  }
}
