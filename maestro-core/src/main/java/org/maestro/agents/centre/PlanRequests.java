package org.maestro.agents.centre;

import jade.lang.acl.ACLMessage;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.agents.content.PlanWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.PlanRecord;
import org.maestro.sl.Content;

/**
 * The questions of others about the plans of a goal that there is: {@code (query-ref (:plans G1))}
 * for the plans with their steps, {@code (query-ref (:bids G1) (:plan 2))} for what was answered
 * when one was made, without a number the latest. Agent thread only.
 */
final class PlanRequests {
  private final MaestroAgent agent;
  private final Coordinator coordinator;

  PlanRequests(MaestroAgent agent, Coordinator coordinator) {
    this.agent = agent;
    this.coordinator = coordinator;
  }

  /** The goal that the question is about, if it is one about plans. */
  static Optional<String> goal(Words words) {
    return words.string("plans").or(() -> words.string("bids"));
  }

  void answer(ACLMessage message, Words words, String goalId) {
    List<PlanRecord> plans = coordinator.plans(goalId);
    if (words.find("bids").isEmpty()) {
      inform(
          message,
          Stream.concat(
                  plans.stream().map(PlanWords::plan),
                  coordinator.stepsOfScript(goalId).stream().map(PlanWords::step))
              .toList());
    } else {
      bids(message, words, goalId, plans);
    }
  }

  private void bids(ACLMessage message, Words words, String goalId, List<PlanRecord> plans) {
    boolean anyWillDo = words.find("plan").isEmpty();
    int number = (int) words.number("plan", 0);
    Optional<PlanRecord> meant =
        plans.stream()
            .filter(plan -> anyWillDo || plan.number() == number)
            .reduce((earlier, later) -> later);
    if (meant.isPresent() || anyWillDo) {
      inform(
          message,
          meant.stream().flatMap(plan -> plan.bids().stream()).map(PlanWords::bid).toList());
    } else {
      agent.refuse(message, ACLMessage.REFUSE, notKept(goalId, number, plans));
    }
  }

  private static String notKept(String goalId, int number, List<PlanRecord> plans) {
    return plans.isEmpty()
        ? "Of %s no plan is kept: plans are kept of the latest goals only, and not beyond a restart."
            .formatted(goalId)
        : "Of %s these plans are kept: %s; plan %d is not."
            .formatted(
                goalId,
                plans.stream()
                    .map(plan -> String.valueOf(plan.number()))
                    .collect(Collectors.joining(", ")),
                number);
  }

  private void inform(ACLMessage message, List<Content> lines) {
    agent.reply(message, ACLMessage.INFORM, lines.toArray(Content[]::new));
  }
}
