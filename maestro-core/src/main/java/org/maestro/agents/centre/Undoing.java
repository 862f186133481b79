package org.maestro.agents.centre;

import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.Caller;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.Former;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.Requester;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.sl.Content;
import org.maestro.sl.SlPrinter;

/**
 * Takes back what goals have changed: they are called off, and what was so before becomes a goal.
 * Agent thread only.
 */
public final class Undoing {
  private final MaestroAgent agent;
  private final Coordinator coordinator;
  private final GoalRequests requests;

  public Undoing(MaestroAgent agent, Coordinator coordinator, GoalRequests requests) {
    this.agent = agent;
    this.coordinator = coordinator;
    this.requests = requests;
  }

  /**
   * {@code (undo (:goal G3))} is answered as the goal is that makes it so again, once nothing that
   * was begun for G3 is under way; by INFORM {@code (inform (:unchanged G3))} where nothing was
   * changed, and by REFUSE where nobody knows what was so before.
   */
  public void undo(ACLMessage message, Words words) {
    String id = words.string("goal").orElse("");
    if (message.getPerformative() != ACLMessage.REQUEST || id.isEmpty()) {
      agent.refuse(
          message, ACLMessage.NOT_UNDERSTOOD, "undo needs a goal, such as (undo (:goal G3)).");
      return;
    }
    Caller caller = Caller.of(message, agent.getHap()).askingFor(words.string("for"));
    if (!requests.mayAsk(caller, message)) {
      return;
    }
    if (!coordinator.hasGoal(id)) {
      agent.refuse(message, ACLMessage.REFUSE, requests.notHere(id));
      return;
    }
    coordinator.cancel(id, caller.toString());
    coordinator.beforeGoal(id, List::of, former -> undo(message, words, id, former));
  }

  /**
   * {@code (query-ref (:before G3))}: what was so before a goal that is over, once nothing that was
   * begun for it is under way.
   */
  public void before(ACLMessage message, Words words) {
    String id = words.string("before").orElse("");
    if (!coordinator.hasGoal(id)) {
      agent.refuse(message, ACLMessage.REFUSE, requests.notHere(id));
    } else if (!coordinator.isOver(id)) {
      agent.refuse(
          message, ACLMessage.REFUSE, "The goal %s is not over; cancel it first.".formatted(id));
    } else {
      coordinator.beforeGoal(id, List::of, former -> tell(message, words, id, former));
    }
  }

  /** To who may read it. */
  private void tell(ACLMessage message, Words words, String id, Former former) {
    ReadingRights rights = requests.rights(message, words);
    if (requests.isPrivate(message, words, id)
        || requests.isKeptBack(message, former.wish().flatMap(rights::objection))) {
      return;
    }
    List<Content.Argument> told = new ArrayList<>();
    told.add(Words.named("goal", Words.name(id)));
    former
        .wish()
        .ifPresent(wish -> told.add(Words.named("before", Words.text(SlPrinter.print(wish)))));
    if (!former.unknown().isEmpty()) {
      told.add(Words.named("unknown", former.unknown().stream().map(Words::text).toList()));
    }
    agent.reply(message, ACLMessage.INFORM, new Content("inform", told));
  }

  /**
   * What a person has asked for last, in whichever way.
   *
   * @param together goals of one sentence of hers, which belong together
   */
  List<String> last(String person, List<String> together) {
    return coordinator.goals().stream()
        .filter(
            goal ->
                !GoalId.isPart(goal.id())
                    && Requester.parse(goal.requester())
                        .person()
                        .filter(person::equals)
                        .isPresent())
        .reduce((earlier, later) -> later)
        .map(goal -> together.contains(goal.id()) ? together : List.of(goal.id()))
        .orElse(List.of());
  }

  /** Calls the goals off, and tells what was so before all of them. */
  void callOff(List<String> goals, String by, Consumer<Former> told) {
    goals.forEach(id -> coordinator.cancel(id, by));
    List<Former> all = new ArrayList<>();
    for (String id : goals) {
      coordinator.beforeGoal(
          id,
          List::of,
          former -> {
            all.add(former);
            if (all.size() == goals.size()) {
              told.accept(
                  new Former(
                      all.stream().flatMap(one -> one.parts().stream()).distinct().toList(),
                      all.stream().flatMap(one -> one.unknown().stream()).toList()));
            }
          });
    }
  }

  private void undo(ACLMessage message, Words words, String id, Former former) {
    if (former.wish().isPresent()) {
      requests.state(message, words, former.wish().get());
    } else if (former.unknown().isEmpty()) {
      agent.reply(
          message,
          ACLMessage.INFORM,
          Words.content("inform", Words.named("unchanged", Words.name(id))));
    } else {
      agent.refuse(
          message,
          ACLMessage.REFUSE,
          "What was so before %s is not known: %s; state what is to be so instead."
              .formatted(id, String.join(", ", former.unknown())));
    }
  }
}
