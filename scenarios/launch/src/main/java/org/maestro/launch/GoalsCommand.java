package org.maestro.launch;

import com.fasterxml.jackson.databind.node.ArrayNode;
import jade.lang.acl.ACLMessage;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.platform.JoinedContainer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Lists a platform's goals. */
@Command(name = "goals", description = "List the goals of a running platform.")
final class GoalsCommand implements Callable<Integer> {
  private static final List<String> COLUMNS =
      List.of(
          "id", "goal", "requester", "state", "priority", "deadline", "age", "waits for", "detail");

  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    try (JoinedContainer container = platform.join()) {
      List<Words> lines =
          Reply.lines(
              container.ask(
                  ACLMessage.QUERY_REF, AgentNames.COORDINATOR, Words.content("query-ref")));
      PrintWriter out = spec.commandLine().getOut();
      if (json) {
        out.println(document(lines));
      } else if (lines.isEmpty()) {
        out.println("No goal was stated yet; try ./maestro goal \"(nextTo Cup Bob)\"");
      } else {
        new Table(COLUMNS, lines.stream().map(GoalsCommand::row).toList()).print(out);
      }
      return ExitCode.DONE;
    }
  }

  private static List<String> row(Words words) {
    List<String> goal = goal(words);
    return List.of(
        goal.isEmpty() ? "-" : goal.get(0),
        goal.size() > 1 ? goal.get(1) : "-",
        words.string("requester").orElse("-"),
        words.string("state").orElse("-"),
        String.valueOf((int) words.number("priority", 0)),
        words.term("deadline").map(left -> seconds(words, "deadline")).orElse("-"),
        seconds(words, "age"),
        waits(words).isEmpty()
            ? "-"
            : waits(words).stream()
                .map(wait -> wait.get(0) + " (" + wait.get(1) + ")")
                .distinct()
                .collect(Collectors.joining(", ")),
        words.string("detail").orElse(""));
  }

  private static List<String> goal(Words words) {
    return words.find("goal").map(Words::terms).orElse(List.of()).stream()
        .map(Words::plain)
        .toList();
  }

  private static String seconds(Words words, String name) {
    return String.format(Locale.ROOT, "%.1f s", words.number(name, 0));
  }

  /** What it waits for, and which goal has that. */
  private static List<List<String>> waits(Words words) {
    return words.find("waits").map(Words::all).orElse(List.of()).stream()
        .map(edge -> Words.of(edge).terms().stream().map(Words::plain).toList())
        .filter(edge -> edge.size() == 2)
        .toList();
  }

  private static String document(List<Words> lines) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode goals = document.node().putArray("goals");
    for (Words words : lines) {
      List<String> goal = goal(words);
      JsonMembers row =
          JsonMembers.in(goals)
              .text("id", goal.stream().findFirst())
              .text("goal", goal.stream().skip(1).findFirst())
              .text("requester", words.string("requester"))
              .text("state", words.string("state"))
              .text("detail", words.string("detail"));
      row.node().put("priority", (int) words.number("priority", 0));
      row.number("deadline_s", words, "deadline").number("age_s", words, "age");
      ArrayNode waits = row.node().putArray("waits");
      for (List<String> edge : waits(words)) {
        JsonMembers.in(waits).text("for", edge.get(0)).text("holder", edge.get(1));
      }
    }
    return document.toString();
  }
}
