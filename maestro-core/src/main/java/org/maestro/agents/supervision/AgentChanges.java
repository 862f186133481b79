package org.maestro.agents.supervision;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.StartWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.DeploymentException;
import org.maestro.sl.Content;

/**
 * Has agents move and go by other descriptions, as those who ask the supervisor want it. Agent
 * thread only.
 */
public final class AgentChanges {
  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(10);
  private static final Duration MOVES_WITHIN = Duration.ofSeconds(100);

  private final MaestroAgent supervisor;
  private final RequestEnds ends;
  private final Containers containers;

  public AgentChanges(MaestroAgent supervisor, Containers containers) {
    this.supervisor = supervisor;
    this.ends = new RequestEnds(supervisor);
    this.containers = containers;
  }

  public void move(ACLMessage message, Words words) {
    String agent = words.string("agent").orElse("");
    String container = words.string("to").orElse("");
    try {
      containers.requireMovable(agent, container);
    } catch (DeploymentException e) {
      supervisor.refuse(
          message, ACLMessage.REFUSE, Objects.requireNonNullElse(e.getMessage(), e.toString()));
      return;
    }
    send(
        agent,
        container,
        answer -> {
          if (answer.getPerformative() == ACLMessage.INFORM) {
            ends.done(message, "The agent " + agent + " lives in " + container + " now.");
          } else {
            supervisor.refuse(
                message,
                answer.getPerformative() == ACLMessage.REFUSE
                    ? ACLMessage.REFUSE
                    : ACLMessage.FAILURE,
                Replies.reason(answer)
                    .orElse("The agent " + agent + " does not answer; is its container alive?"));
          }
        });
  }

  /** Has it go when nothing is under way with it; tells how that ended. */
  public void send(String agent, String container, Consumer<ACLMessage> ended) {
    supervisor.ask(
        supervisor.message(
            ACLMessage.REQUEST,
            supervisor.getAID(agent),
            Words.content(
                "perform",
                Words.named("action", Words.name("move")),
                Words.named("container", Words.name(container)))),
        MOVES_WITHIN,
        answer -> {
          if (answer.getPerformative() != ACLMessage.AGREE) {
            if (answer.getPerformative() == ACLMessage.INFORM) {
              containers.moved(agent, container);
            }
            ended.accept(answer);
          }
        });
  }

  public void reconfigure(ACLMessage message, Words words) {
    String agent = words.string("agent").orElse("");
    try {
      AgentStart wanted =
          containers.reconfigured(
              agent, words.string("description").orElse(""), RequestEnds.source(words));
      List<Content.Argument> arguments = new ArrayList<>();
      arguments.add(Words.named("action", Words.name("configure")));
      arguments.addAll(StartWords.charges(wanted.charges()));
      supervisor.ask(
          supervisor.message(
              ACLMessage.REQUEST, supervisor.getAID(agent), new Content("perform", arguments)),
          ANSWER_WITHIN,
          answer -> {
            if (answer.getPerformative() == ACLMessage.INFORM) {
              containers.configured(wanted);
              ends.done(message, "The agent " + agent + " is configured anew.");
            } else if (answer.getPerformative() != ACLMessage.AGREE) {
              supervisor.refuse(
                  message,
                  ACLMessage.REFUSE,
                  Replies.reason(answer).orElse("The agent " + agent + " does not answer."));
            }
          });
    } catch (RuntimeException e) {
      ends.failed(message, e);
    }
  }
}
