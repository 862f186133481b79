package org.maestro.agents.knowledge;

import jade.lang.acl.ACLMessage;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import org.maestro.agents.content.BeliefWords;
import org.maestro.agents.content.Words;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.sl.Content;

/**
 * The subscriptions of those who keep a copy of all that is believed (ADE, 3; A15): they are told
 * it once, and then what changes. The agent's thread only, but for {@link #isEmpty}.
 */
public final class BeliefSubscriptions {
  private static final String UNKNOWN = "(unknown ";

  private final BiConsumer<ACLMessage, List<Content>> inform;
  private final List<Subscription> subscriptions = new ArrayList<>();
  private volatile boolean empty = true;

  private record Subscription(ACLMessage request, ReadingRights rights) {}

  /**
   * @param inform answers a request
   */
  public BeliefSubscriptions(BiConsumer<ACLMessage, List<Content>> inform) {
    this.inform = inform;
  }

  /** Any thread may ask. */
  public boolean isEmpty() {
    return empty;
  }

  /** Tells all that is believed now, and from now on what changes. */
  public void add(ACLMessage request, ReadingRights rights, Snapshot now) {
    Subscription subscription = new Subscription(request, rights);
    subscriptions.add(subscription);
    empty = false;
    List<Content> all =
        now.beliefs().stream()
            .filter(belief -> rights.mayReadFact(belief.fact()))
            .map(belief -> BeliefWords.content(belief, now.at()))
            .toList();
    // That nothing is believed is told too: who copies knows then that he is told.
    inform.accept(
        request,
        all.isEmpty()
            ? List.of(Words.content("inform", Words.named("answers", Words.name("none"))))
            : all);
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

  /** Tells what a change has made of what is believed. */
  public void changed(KnowledgeBase.Change change, Snapshot now) {
    List<Belief> beliefs = now.beliefs();
    for (Subscription subscription : subscriptions) {
      List<Content> news = news(change, beliefs, now.at(), subscription.rights());
      if (!news.isEmpty()) {
        inform.accept(subscription.request(), news);
      }
    }
  }

  /** What is not known any more comes first: the same may be known in another way now. */
  private static List<Content> news(
      KnowledgeBase.Change change, List<Belief> beliefs, Instant at, ReadingRights rights) {
    List<Content> lost = new ArrayList<>();
    Map<String, Belief> come = new LinkedHashMap<>();
    for (String fact : change.facts()) {
      if (fact.startsWith(UNKNOWN)) {
        if (rights.mayReadFact(fact)) {
          lost.add(Words.content("inform", Words.named("unknown", Words.text(fact))));
        }
      } else {
        beliefs.stream()
            .filter(belief -> belief.fact().equals(fact))
            .forEach(belief -> with(come, belief, beliefs));
      }
    }
    return Stream.concat(
            lost.stream(),
            come.values().stream()
                .filter(belief -> rights.mayReadFact(belief.fact()))
                .map(belief -> BeliefWords.content(belief, at)))
        .toList();
  }

  /** A device states all that it says of itself each time. */
  private static void with(Map<String, Belief> come, Belief belief, List<Belief> beliefs) {
    come.put(belief.fact(), belief);
    if (belief.source().kind() == Source.Kind.STATED) {
      beliefs.stream()
          .filter(other -> other.source().equals(belief.source()))
          .forEach(other -> come.put(other.fact(), other));
    }
  }
}
