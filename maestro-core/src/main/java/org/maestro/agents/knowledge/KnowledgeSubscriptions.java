package org.maestro.agents.knowledge;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import org.maestro.knowledge.Question;
import org.maestro.knowledge.api.Answer;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The subscriptions of those who want to be told when the answer to a question changes: passive
 * communication through what is known (Three-layered architecture, 2; M15). The agent's thread
 * only, but for {@link #isEmpty}.
 */
public final class KnowledgeSubscriptions {

  private final BiConsumer<ACLMessage, List<Answer>> inform;
  private final BiConsumer<ACLMessage, String> end;
  private final List<Subscription> subscriptions = new ArrayList<>();
  private volatile boolean empty = true;

  /** A question to which somebody has subscribed, and what was answered last. */
  private static final class Subscription {
    private final ACLMessage request;
    private final Formula formula;
    private final Optional<Duration> within;
    private final Supplier<ReadingRights> rights;
    private Map<Map<String, Term>, Truth> told = Map.of();

    Subscription(
        ACLMessage request,
        Formula formula,
        Optional<Duration> within,
        Supplier<ReadingRights> rights) {
      this.request = request;
      this.formula = formula;
      this.within = within;
      this.rights = rights;
    }
  }

  /**
   * @param inform answers a request with all that is so now
   * @param end tells why a request is answered no more
   */
  public KnowledgeSubscriptions(
      BiConsumer<ACLMessage, List<Answer>> inform, BiConsumer<ACLMessage, String> end) {
    this.inform = inform;
    this.end = end;
  }

  /** Any thread may ask. */
  public boolean isEmpty() {
    return empty;
  }

  /**
   * Answers at once, and again whenever the answer changes.
   *
   * @param rights of who asks, as they are at the time: whose are taken away is told nothing more
   */
  public void add(
      ACLMessage request,
      Formula formula,
      Optional<Duration> within,
      Supplier<ReadingRights> rights,
      Snapshot now) {
    Subscription subscription = new Subscription(request, formula, within, rights);
    subscriptions.add(subscription);
    empty = false;
    tell(subscription, answers(subscription, now));
  }

  /** Ends those of the same sender and conversation; returns whether there were any. */
  public boolean cancel(ACLMessage cancel) {
    boolean found =
        subscriptions.removeIf(
            subscription ->
                Objects.equals(subscription.request.getSender(), cancel.getSender())
                    && Objects.equals(
                        subscription.request.getConversationId(), cancel.getConversationId()));
    empty = subscriptions.isEmpty();
    return found;
  }

  public void changed(Snapshot now) {
    for (Subscription subscription : List.copyOf(subscriptions)) {
      Optional<String> objection = subscription.rights.get().objection(subscription.formula);
      if (objection.isPresent()) {
        subscriptions.remove(subscription);
        empty = subscriptions.isEmpty();
        end.accept(subscription.request, objection.get());
        continue;
      }
      List<Answer> answers = answers(subscription, now);
      if (!subscription.told.equals(truths(answers))) {
        tell(subscription, answers);
      }
    }
  }

  private static List<Answer> answers(Subscription subscription, Snapshot now) {
    Question question =
        new Question(
            subscription.within.map(now::notOlderThan).orElse(now), subscription.rights.get());
    List<Answer> bound = question.answerRef(subscription.formula);
    return bound.isEmpty() ? List.of(question.answerIf(subscription.formula)) : bound;
  }

  private static Map<Map<String, Term>, Truth> truths(List<Answer> answers) {
    Map<Map<String, Term>, Truth> truths = new LinkedHashMap<>();
    answers.forEach(answer -> truths.put(answer.binding(), answer.truth()));
    return truths;
  }

  private void tell(Subscription subscription, List<Answer> answers) {
    subscription.told = truths(answers);
    inform.accept(subscription.request, answers);
  }
}
