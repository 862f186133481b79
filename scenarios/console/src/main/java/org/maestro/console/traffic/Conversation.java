package org.maestro.console.traffic;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.platform.jade.SentMessage;

/**
 * A conversation between agents, by the messages of it that are kept.
 *
 * @param id under which it is shown
 * @param messages oldest first; there is one at least
 */
record Conversation(String id, List<Ring.Kept<Mail>> messages) {
  /** After these who was asked owes nothing more. */
  private static final Set<String> ENDS =
      Set.of("inform", "inform-ref", "refuse", "failure", "not-understood", "reject-proposal");

  private static final Set<String> FAILURES = Set.of("failure", "not-understood");

  /** What has become of a conversation, as far as its messages tell. */
  enum State {
    OPEN,
    DONE,
    REFUSED,
    FAILED,
    CANCELLED
  }

  SentMessage first() {
    return messages.get(0).what().message();
  }

  Mail latest() {
    return messages.get(messages.size() - 1).what();
  }

  Optional<String> protocol() {
    return messages.stream().flatMap(kept -> kept.what().message().protocol().stream()).findFirst();
  }

  /** Who takes part, by whole names, in the order in which they came in. */
  Set<String> participants() {
    Set<String> names = new LinkedHashSet<>();
    for (Ring.Kept<Mail> kept : messages) {
      names.add(kept.what().message().sender());
      names.add(kept.what().message().receiver());
    }
    return names;
  }

  /** How often each performative was said. */
  Map<String, Integer> performatives() {
    Map<String, Integer> counts = new LinkedHashMap<>();
    messages.forEach(kept -> counts.merge(kept.what().message().performative(), 1, Integer::sum));
    return counts;
  }

  /** Open as long as anybody who was spoken to by who began it has not said the last word. */
  State state() {
    Map<String, String> lastByPartner = new LinkedHashMap<>();
    String initiator = first().sender();
    for (Ring.Kept<Mail> kept : messages) {
      SentMessage message = kept.what().message();
      String partner = message.sender().equals(initiator) ? message.receiver() : message.sender();
      lastByPartner.put(partner, message.performative());
    }
    if (lastByPartner.values().stream().anyMatch("cancel"::equals)) {
      return State.CANCELLED;
    }
    if (!lastByPartner.values().stream().allMatch(this::isEnd)) {
      return State.OPEN;
    }
    if (lastByPartner.values().stream().anyMatch(FAILURES::contains)) {
      return State.FAILED;
    }
    return lastByPartner.values().stream().allMatch("refuse"::equals) ? State.REFUSED : State.DONE;
  }

  /** Who has subscribed to something is informed again and again. */
  private boolean isEnd(String performative) {
    return ENDS.contains(performative)
        && !(performative.startsWith("inform") && first().performative().equals("subscribe"));
  }
}
