package org.maestro.launch;

import jade.lang.acl.ACLMessage;
import java.util.concurrent.Callable;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.platform.JoinedContainer;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** A request to the supervisor of a running platform, for the action of the command's name. */
abstract class SupervisorRequest implements Callable<Integer> {
  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  private final String done;

  /**
   * @param done what is said then, a sentence
   */
  SupervisorRequest(String done) {
    this.done = done;
  }

  @Override
  public Integer call() {
    try (JoinedContainer container = platform.join()) {
      Reply.lines(
          container.ask(
              ACLMessage.REQUEST,
              AgentNames.SUPERVISOR,
              Words.content("perform", Words.named("action", Words.name(spec.name())))));
      spec.commandLine().getOut().println(done);
      return ExitCode.DONE;
    }
  }
}
