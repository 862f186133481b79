package org.maestro.agents.supervision;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.Collection;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.StartWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.Conversations;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.deployment.AgentStart;

/**
 * The orders and news to other agents for the supervisor: hosts are asked to start agents and to
 * let names go, and whoever counts on a member is told that it is gone. Any thread may call.
 */
public final class SupervisorOrders {
  private static final Duration HOST_WITHIN = Duration.ofSeconds(10);

  private final MaestroAgent supervisor;

  public SupervisorOrders(MaestroAgent supervisor) {
    this.supervisor = supervisor;
  }

  /**
   * Has a host start an agent, configured as it was. Any thread may call.
   *
   * @param problem is told on this agent's thread why it is not started, or nothing when it is
   */
  public void beginOn(
      String host, AgentStart start, String controller, Consumer<Optional<String>> problem) {
    supervisor.tell(
        () ->
            supervisor.ask(
                supervisor.message(
                    ACLMessage.REQUEST,
                    supervisor.getAID(AgentNames.ofHost(host)),
                    Words.content(
                        "perform",
                        Words.named("action", Words.name("host")),
                        Words.named("controller", Words.text(controller))),
                    StartWords.content(start)),
                HOST_WITHIN,
                reply -> {
                  if (Conversations.isFinal(reply)) {
                    problem.accept(
                        reply.getPerformative() == ACLMessage.INFORM
                            ? Optional.empty()
                            : Replies.reason(reply).or(() -> Optional.of("no answer")));
                  }
                }));
  }

  /**
   * Has a host end its calls under a controller's name, and waits for that; not to be called by an
   * agent.
   */
  public void letGo(String host, String controller) {
    CompletableFuture<ACLMessage> answered = new CompletableFuture<>();
    supervisor.tell(
        () ->
            supervisor.ask(
                supervisor.message(
                    ACLMessage.REQUEST,
                    supervisor.getAID(AgentNames.ofHost(host)),
                    Words.content(
                        "perform",
                        Words.named("action", Words.name("let-go")),
                        Words.named("controller", Words.text(controller)))),
                HOST_WITHIN,
                reply -> {
                  if (Conversations.isFinal(reply)) {
                    answered.complete(reply);
                  }
                }));
    // The conversation ends in any case, also when the host is gone: then its calls are over too.
    answered.join();
  }

  /** Tells agents that count on a member that it is gone. Any thread may call. */
  public void tellLost(String member, String reason, Collection<String> agents) {
    supervisor.tell(
        () ->
            agents.forEach(
                agent ->
                    supervisor.send(
                        supervisor.message(
                            ACLMessage.INFORM,
                            supervisor.getAID(agent),
                            Words.content(
                                "inform",
                                Words.named("member", Words.name(member)),
                                Words.named("phase", Words.name("lost")),
                                Words.named("reason", Words.text(reason)))))));
  }
}
