package org.maestro.launch;

import jade.lang.acl.ACLMessage;
import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import org.maestro.agents.CoordinatorAgent;
import org.maestro.agents.Words;
import org.maestro.platform.JoinedContainer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Lists a platform's goals. */
@Command(name = "goals", description = "List the goals of a running platform.")
final class GoalsCommand implements Callable<Integer> {
  private static final List<String> COLUMNS = List.of("id", "goal", "requester", "state", "detail");

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
                  ACLMessage.QUERY_REF, CoordinatorAgent.NAME, Words.content("query-ref")));
      Table table = new Table(COLUMNS, lines.stream().map(GoalsCommand::row).toList());
      PrintWriter out = spec.commandLine().getOut();
      if (json) {
        out.println(table.json("goals"));
      } else if (lines.isEmpty()) {
        out.println("No goal was stated yet; try ./maestro goal \"(nextTo Cup Bob)\"");
      } else {
        table.print(out);
      }
      return ExitCode.DONE;
    }
  }

  private static List<String> row(Words words) {
    List<String> goal =
        words.find("goal").map(Words::terms).orElse(List.of()).stream().map(Words::plain).toList();
    return List.of(
        goal.isEmpty() ? "-" : goal.get(0),
        goal.size() > 1 ? goal.get(1) : "-",
        words.string("requester").orElse("-"),
        words.string("state").orElse("-"),
        words.string("detail").orElse(""));
  }
}
