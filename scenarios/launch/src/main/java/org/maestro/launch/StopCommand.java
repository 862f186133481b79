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

/** Brings all devices to a stand. */
@Command(name = "stop", description = "Every device into a safe state, now; the platform stays.")
final class StopCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Override
  public Integer call() {
    try (JoinedContainer container = platform.join()) {
      Reply.lines(
          container.ask(
              ACLMessage.REQUEST,
              AgentNames.SUPERVISOR,
              Words.content("perform", Words.named("action", Words.name("stop")))));
      spec.commandLine().getOut().println("Every device was told to go into a safe state.");
      return ExitCode.DONE;
    }
  }
}
