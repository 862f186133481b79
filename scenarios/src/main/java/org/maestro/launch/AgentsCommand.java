package org.maestro.launch;

import jade.lang.acl.ACLMessage;
import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import org.maestro.agents.SupervisorAgent;
import org.maestro.agents.Words;
import org.maestro.platform.JoinedContainer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Lists a platform's agents. */
@Command(name = "agents", description = "List the agents of a running platform, and their members.")
final class AgentsCommand implements Callable<Integer> {
  private static final List<String> COLUMNS = List.of("agent", "container", "phase", "state");

  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    try (JoinedContainer container = platform.join()) {
      Table table =
          new Table(
              COLUMNS,
              Reply.lines(
                      container.ask(
                          ACLMessage.QUERY_REF, SupervisorAgent.NAME, Words.content("query-ref")))
                  .stream()
                  .map(words -> COLUMNS.stream().map(c -> words.string(c).orElse("-")).toList())
                  .toList());
      PrintWriter out = spec.commandLine().getOut();
      if (json) {
        out.println(table.json("agents"));
      } else {
        table.print(out);
      }
      return ExitCode.DONE;
    }
  }
}
