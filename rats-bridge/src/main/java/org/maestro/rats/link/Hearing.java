package org.maestro.rats.link;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Transport.RetainedMessages;

/**
 * Of which members a link hears: of all, or of those only that somebody watches there. Hundreds of
 * links that hear of hundreds of members each would be told much more than they need. Clock thread
 * only, once it has begun.
 */
final class Hearing {
  private final boolean ofAll;
  private final Topics topics;
  private final Handlers handlers;
  private final Subscriber subscriber;
  private final Set<String> followed = new LinkedHashSet<>();

  /** Subscribes for the life of the link. */
  interface Subscriber {
    void subscribe(String filter, RetainedMessages retained, Consumer<Message> handler);
  }

  /** The handlers of what members publish of themselves. */
  record Handlers(
      Consumer<Message> status,
      Consumer<Message> description,
      Consumer<Message> state,
      Consumer<Message> observation) {}

  Hearing(boolean ofAll, Topics topics, Handlers handlers, Subscriber subscriber) {
    this.ofAll = ofAll;
    this.topics = topics;
    this.handlers = handlers;
    this.subscriber = subscriber;
  }

  boolean isOfAll() {
    return ofAll;
  }

  void begin() {
    if (ofAll) {
      hear(topics.statuses(), topics.descriptions(), topics.states(), topics.observations());
    }
  }

  /**
   * @return whether it has not been heard of until now
   */
  boolean follow(String member) {
    if (ofAll || !followed.add(member)) {
      return false;
    }
    hear(
        topics.status(member),
        topics.description(member),
        topics.state(member),
        topics.observation(member, "+"));
    return true;
  }

  private void hear(String statuses, String descriptions, String states, String observations) {
    subscriber.subscribe(statuses, RetainedMessages.SEND, handlers.status());
    subscriber.subscribe(descriptions, RetainedMessages.SEND, handlers.description());
    subscriber.subscribe(states, RetainedMessages.SEND, handlers.state());
    subscriber.subscribe(observations, RetainedMessages.IGNORE, handlers.observation());
  }

  /** Whom to ask for something that concerns whoever is heard of; empty for all at once. */
  List<Optional<String>> addressees() {
    List<Optional<String>> each = new ArrayList<>();
    followed.forEach(member -> each.add(Optional.of(member)));
    return ofAll ? List.of(Optional.empty()) : each;
  }
}
