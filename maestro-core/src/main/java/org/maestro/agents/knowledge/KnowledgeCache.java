package org.maestro.agents.knowledge;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.SlSyntaxException;

/**
 * A cache of the answers that an agent in another process reads of the collective knowledge. A
 * question is asked of the knowledge agent once, as a subscription; from then on it is answered
 * here, and stays right, as each change is told. Of many questions those read last are kept, the
 * others' subscriptions are cancelled. Agent thread only.
 */
public final class KnowledgeCache {
  private final MaestroAgent agent;
  private final int most;
  private final Map<Asked, Entry> entries = new LinkedHashMap<>(16, 0.75f, true);

  /** A question, and for whom it is asked. */
  private record Asked(Formula question, Optional<String> person) {
    Content content() {
      List<Content.Argument> arguments = new ArrayList<>(List.of(Words.formula(question)));
      person.ifPresent(name -> arguments.add(Words.named("for", Words.text(name))));
      return new Content("subscribe", arguments);
    }
  }

  /** A question, and what was answered last; until then who waits for it. */
  private static final class Entry {
    private final List<Consumer<Known>> waiting = new ArrayList<>();
    private final List<Consumer<Known>> followers = new ArrayList<>();
    private String conversation = "";
    private List<Content> answers = List.of();
    private Duration heard = Duration.ZERO;
    private boolean known;
  }

  /**
   * Answers to a question.
   *
   * @param answers in the words of the knowledge agent; their ages are of when it told
   * @param since how long ago it told
   * @param failure why there are none, one sentence; empty when there are
   */
  public record Known(List<Content> answers, Duration since, String failure) {
    public boolean isFailure() {
      return !failure.isEmpty();
    }
  }

  /**
   * @param most questions that are kept current
   */
  public KnowledgeCache(MaestroAgent agent, int most) {
    this.agent = agent;
    this.most = most;
  }

  /**
   * Answers at once what is known here, and anything else when the knowledge agent has.
   *
   * @param told once
   */
  public void read(Formula question, Consumer<Known> told) {
    read(question, Optional.empty(), told);
  }

  /**
   * The same for a person, who may be told other things than others.
   *
   * @param person who has signed in; empty: nobody in particular
   */
  public void read(Formula question, Optional<String> person, Consumer<Known> told) {
    Entry entry = entry(new Asked(question, person));
    if (entry.known) {
      told.accept(known(entry));
    } else {
      entry.waiting.add(told);
    }
  }

  /** The same, and again whenever the answer changes, as long as the question is kept. */
  public void follow(Formula question, Consumer<Known> told) {
    Entry entry = entry(new Asked(question, Optional.empty()));
    entry.followers.add(told);
    if (entry.known) {
      told.accept(known(entry));
    }
  }

  int size() {
    return entries.size();
  }

  private Entry entry(Asked question) {
    Entry known = entries.get(question);
    if (known != null) {
      return known;
    }
    Entry entry = new Entry();
    entries.put(question, entry);
    entry.conversation =
        agent
            .conversations()
            .subscribe(
                agent.message(
                    ACLMessage.SUBSCRIBE, agent.getAID(AgentNames.KNOWLEDGE), question.content()),
                reply -> heard(question, entry, reply));
    if (entries.size() > most) {
      forget(entries.keySet().iterator().next());
    }
    return entry;
  }

  private void forget(Asked question) {
    Entry oldest = entries.remove(question);
    end(oldest);
    ACLMessage cancel =
        agent.message(
            ACLMessage.CANCEL, agent.getAID(AgentNames.KNOWLEDGE), Words.content("cancel"));
    cancel.setConversationId(oldest.conversation);
    agent.send(cancel);
    tell(oldest, new Known(List.of(), Duration.ZERO, "Too many questions were asked since."));
  }

  /** What is cancelled, or cannot be heard of, is not waited for any more. */
  private void end(Entry entry) {
    agent.conversations().close(entry.conversation);
  }

  private void heard(Asked question, Entry entry, ACLMessage reply) {
    if (reply.getPerformative() == ACLMessage.AGREE) {
      return;
    }
    if (reply.getPerformative() != ACLMessage.INFORM) {
      entries.remove(question, entry);
      end(entry);
      tell(entry, new Known(List.of(), Duration.ZERO, reason(reply)));
      return;
    }
    try {
      entry.answers = Words.parse(reply.getContent());
      entry.heard = agent.clock().now();
      entry.known = true;
      tell(entry, known(entry));
    } catch (SlSyntaxException e) {
      entries.remove(question, entry);
      end(entry);
      tell(
          entry,
          new Known(
              List.of(), Duration.ZERO, Objects.requireNonNullElse(e.getMessage(), e.toString())));
    }
  }

  private static String reason(ACLMessage reply) {
    return Replies.reason(reply).orElse("The knowledge agent does not answer.");
  }

  private Known known(Entry entry) {
    return new Known(entry.answers, agent.clock().now().minus(entry.heard), "");
  }

  private static void tell(Entry entry, Known known) {
    List<Consumer<Known>> waiting = List.copyOf(entry.waiting);
    entry.waiting.clear();
    waiting.forEach(told -> told.accept(known));
    List.copyOf(entry.followers).forEach(told -> told.accept(known));
  }
}
