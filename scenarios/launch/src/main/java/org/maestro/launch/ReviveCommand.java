package org.maestro.launch;

import jade.lang.acl.ACLMessage;
import java.util.concurrent.Callable;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.platform.JoinedContainer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** Starts the central coordination agent again after it was ended, as in the JADE GUI. */
@Command(
    name = "revive",
    description = "Start the central coordination agent again after it was ended.")
final class ReviveCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Override
  public Integer call() {
    try (JoinedContainer container = platform.join()) {
      Reply.lines(
          container.ask(
              ACLMessage.REQUEST,
              AgentNames.SUPERVISOR,
              Words.content("perform", Words.named("action", Words.name("revive")))));
      spec.commandLine().getOut().println("The central coordination agent is there again.");
      return ExitCode.DONE;
    }
  }
}
