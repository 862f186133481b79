package org.maestro.launch;

import jade.lang.acl.ACLMessage;
import java.io.PrintWriter;
import java.util.ArrayList;
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
      List<Words> lines =
          Reply.lines(
              container.ask(
                  ACLMessage.QUERY_REF, AgentNames.SUPERVISOR, Words.content("query-ref")));
      String own = container.name();
      List<List<String>> rows = new ArrayList<>();
      for (Words line : lines) {
        boolean isPlace = line.string("place").isPresent();
        if (isPlace == containers && !at(line).equals(own)) {
          rows.add(isPlace ? place(line) : agent(line));
        }
      }
      Table table = new Table(columns(), rows);
      PrintWriter out = spec.commandLine().getOut();
      if (json) {
        out.println(table.json(containers ? "containers" : "agents"));
      } else {
        table.print(out);
        lines.stream()
            .filter(line -> !containers && line.string(WHY).isPresent())
            .map(line -> all(line, "members") + " is refused: " + line.string(WHY).orElse(""))
            .forEach(sentence -> out.println(VisibleText.line(sentence)));
      }
      return ExitCode.DONE;
    }
  }

  /** How a process was started, and why a member is refused, are too long for a table. */
  private List<String> columns() {
    List<String> columns = new ArrayList<>(containers ? CONTAINERS : AGENTS);
    if (containers && json) {
      columns.addAll(STARTS);
    } else if (json) {
      columns.add(WHY);
    }
    return columns;
  }

  private static String at(Words line) {
    return line.string("place").or(() -> line.string("container")).orElse("");
  }

  private List<String> agent(Words line) {
    List<String> cells = new ArrayList<>();
    cells.addAll(
        List.of(
            line.string("agent").orElse("-"),
            line.string("container").orElse("-"),
            all(line, "members"),
            line.string("phase").orElse("-"),
            line.string("state").orElse("-"),
            line.string("life").orElse("-"),
            since(line),
            all(line, "services")));
    if (json) {
      cells.add(line.string(WHY).orElse("-"));
    }
    return cells;
  }

  private List<String> place(Words line) {
    Optional<Words> start = line.find("started").filter(its -> its.string("pid").isPresent());
    List<String> cells = new ArrayList<>();
    cells.addAll(
        List.of(
            line.string("place").orElse("-"),
            line.string("process").orElse("-"),
            all(line, "topics"),
            all(line, "provides"),
            since(line),
            line.string("address").orElse("-"),
            machine(start),
            all(line, "holds")));
    if (json) {
      STARTS.forEach(part -> cells.add(start.flatMap(its -> its.string(part)).orElse("-")));
    }
    return cells;
  }

  private static String machine(Optional<Words> start) {
    return start
        .map(its -> its.string("machine").orElse("-") + " pid " + its.string("pid").orElse("-"))
        .orElse("-");
  }

  private static String all(Words line, String name) {
    List<String> words =
        line.find(name).map(Words::terms).orElse(List.of()).stream().map(Words::plain).toList();
    return words.isEmpty() ? "-" : String.join(" ", words);
  }

  /** For programs the moment on the platform's clock, for people how long ago that is. */
  private String since(Words line) {
    if (json) {
      return line.string("since").orElse("-");
    }
    long seconds = Math.round(line.number("age", 0));
    if (seconds < MINUTE) {
      return seconds + " s";
    }
    return seconds < HOUR
        ? seconds / MINUTE + " min " + seconds % MINUTE + " s"
        : seconds / HOUR + " h " + seconds % HOUR / MINUTE + " min";
  }
}
