package org.maestro.launch;

import jade.lang.acl.ACLMessage;
import java.util.concurrent.Callable;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.platform.JoinedContainer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Gives a goal up. */
@Command(name = "cancel", description = "Give a goal up; what runs ends by its exit strategy.")
final class CancelCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Parameters(paramLabel = "GOAL", description = "A goal's id, such as G1.")
  private String goal;

  @Override
  public Integer call() {
    try (JoinedContainer container = platform.join()) {
      Reply.lines(
          container.ask(
              ACLMessage.REQUEST,
              AgentNames.COORDINATOR,
              Words.content("cancel", Words.named("goal", Words.name(goal)))));
      spec.commandLine().getOut().println(goal + " is cancelled.");
      return ExitCode.DONE;
    }
  }
}
