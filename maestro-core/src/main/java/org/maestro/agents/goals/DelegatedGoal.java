package org.maestro.agents.goals;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;

/**
 * An effect that an agent asks of the central agent, by FIPA request as anybody would
 * (Three-layered architecture, 1 and 2; M5, M14): it says what is to be so, not which device is to
 * do what. Agent thread only.
 */
final class DelegatedGoal {
  private static final Duration NO_END = Duration.ofDays(365);

  private final MaestroAgent agent;
  private final Formula effect;
  private final Consumer<String> accepted;
  private final BiConsumer<DelegatedGoal, Optional<String>> ended;
  private Optional<String> goalId = Optional.empty();
  private boolean open = true;

  /**
   * @param accepted told the id under which the central agent pursues it
   * @param ended told once: empty when the effect was reached, otherwise why not
   */
  DelegatedGoal(
      MaestroAgent agent,
      Formula effect,
      Consumer<String> accepted,
      BiConsumer<DelegatedGoal, Optional<String>> ended) {
    this.agent = agent;
    this.effect = effect;
    this.accepted = accepted;
    this.ended = ended;
  }

  void send() {
    ask(Words.content("initCNP", Words.named("goal", Words.formula(effect))));
  }

  /** It was asked before a restart, and is pursued under that id. */
  void await(String petitionId) {
    goalId = Optional.of(petitionId);
    ask(Words.content("await", Words.named("goal", Words.name(petitionId))));
  }

  private void ask(Content request) {
    agent.ask(
        agent.message(ACLMessage.REQUEST, agent.getAID(AgentNames.COORDINATOR), request),
        NO_END,
        this::answered);
  }

  Formula effect() {
    return effect;
  }

  private void answered(ACLMessage reply) {
    switch (reply.getPerformative()) {
      case ACLMessage.AGREE -> {
        goalId =
            Words.parse(reply.getContent()).stream()
                .flatMap(content -> Words.of(content).string("goal").stream())
                .findFirst();
        goalId.ifPresent(accepted);
      }
      case ACLMessage.CONFIRM, ACLMessage.DISCONFIRM -> {
        // A held effect that begins or ceases to be so shows in the collective knowledge.
      }
      case ACLMessage.INFORM -> end(Optional.empty());
      default ->
          end(
              Optional.of(
                  Replies.isFromPlatform(reply)
                      ? "there is no central agent to ask"
                      : "the central agent says: "
                          + Replies.reason(reply).orElse("no reason given")));
    }
  }

  private void end(Optional<String> problem) {
    if (open) {
      open = false;
      ended.accept(this, problem);
    }
  }

  /** It is not wanted any more. */
  void withdraw() {
    open = false;
    goalId.ifPresent(
        id ->
            agent.send(
                agent.message(
                    ACLMessage.REQUEST,
                    agent.getAID(AgentNames.COORDINATOR),
                    Words.content("cancel", Words.named("goal", Words.name(id))))));
  }
}
