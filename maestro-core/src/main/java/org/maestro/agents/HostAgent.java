package org.maestro.agents;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.StartWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.Conversations;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.deployment.AgentStart;
import org.maestro.sl.Content;

/**
 * Stands for a process that offers itself as a host: starts and ends agents there when the
 * supervisor asks for it. That it ends tells the platform that the host is gone.
 */
public final class HostAgent extends MaestroAgent {
  private static final long serialVersionUID = 1L;

  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(20);

  /** The operations of a host; they may take long, and are called by a thread of its own. */
  public interface Host {
    /**
     * Starts an agent.
     *
     * @param controller under whose name it calls members
     * @throws RuntimeException with one sentence when it cannot
     */
    void begin(AgentStart start, String controller);

    /** Calls nobody under the controller's name any more: it is there again itself. */
    void letGo(String controller);
  }

  private final transient Host host;

  public HostAgent(Birth birth, AgentTime time, Host host) {
    super(birth, time);
    this.host = host;
  }

  /**
   * Offers the host to the supervisor. Any thread may call.
   *
   * @param name of the host, by which this agent is called
   * @param answer gets the final reply, on this agent's thread
   */
  public void offer(String name, List<String> provides, Consumer<ACLMessage> answer) {
    tell(
        () ->
            ask(
                message(
                    ACLMessage.REQUEST,
                    getAID(AgentNames.SUPERVISOR),
                    Words.content(
                        "perform",
                        Words.named("action", Words.name("offer")),
                        Words.named("host", Words.text(name)),
                        Words.named("provides", provides.stream().map(Words::text).toList()))),
                ANSWER_WITHIN,
                reply -> {
                  if (Conversations.isFinal(reply)) {
                    answer.accept(reply);
                  }
                }));
  }

  @Override
  protected void received(ACLMessage message) {
    List<Content> contents = Words.parse(message.getContent());
    Words words = Words.of(contents.get(0));
    String action = words.string("action").orElse("");
    String controller = words.string("controller").orElse("");
    boolean isAsked =
        contents.get(0).operator().equals("perform")
            && message.getSender().getLocalName().equals(AgentNames.SUPERVISOR);
    if (isAsked && action.equals("host") && contents.size() > 1) {
      AgentStart start = StartWords.read(Words.of(contents.get(1)));
      beside(message, () -> host.begin(start, controller));
    } else if (isAsked && action.equals("let-go")) {
      beside(message, () -> host.letGo(controller));
    } else {
      refuse(
          message,
          ACLMessage.REFUSE,
          getLocalName() + " starts agents, and only when the supervisor asks for it.");
    }
  }

  /** Starting an agent waits for JADE, which an agent must not. */
  private void beside(ACLMessage message, Runnable work) {
    if (isCutOff()) {
      refuse(message, ACLMessage.REFUSE, getLocalName() + " was cut off from the platform.");
      return;
    }
    Thread starter =
        new Thread(
            () -> {
              try {
                work.run();
                tell(() -> done(message));
              } catch (RuntimeException e) {
                tell(() -> refuse(message, ACLMessage.FAILURE, String.valueOf(e.getMessage())));
              }
            },
            "agent-starter");
    starter.setDaemon(true);
    starter.start();
  }

  private void done(ACLMessage message) {
    reply(
        message,
        ACLMessage.INFORM,
        Words.content("inform", Words.named("done", Words.name("host"))));
  }
}
