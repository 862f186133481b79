package org.maestro.console.traffic;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.documents.ShownText;
import org.maestro.platform.jade.SentMessage;
import org.maestro.rats.bounded.BoundedMap;

/**
 * The latest messages between agents, and the conversations that they make up (Three-layered
 * architecture, 3.3.2; M73). They are kept as they were sent; conversations are made of them when
 * somebody looks.
 */
public final class MailTraffic implements Source {
  private static final int MOST_MESSAGES = 3_000;
  private static final long MOST_CHARACTERS = 4_000_000;
  private static final int LONGEST_CONTENT = 16_000;
  private static final int MOST_LEFT_OUT = 1_000;

  private final Predicate<SentMessage> leftOut;
  private final Supplier<Duration> now;
  private final Supplier<List<String>> elsewhere;
  private final ConversationDocument documents;
  private final Ring<Mail> ring = new Ring<>(MOST_MESSAGES, MOST_CHARACTERS);

  // As many as there are messages: who has one that is kept is not forgotten.
  private final Map<String, String> ids = BoundedMap.ofLatelyUsed(MOST_MESSAGES + 1);
  private final Map<String, Boolean> notKept = BoundedMap.ofNewest(MOST_LEFT_OUT);
  private long conversations;

  /**
   * @param platform its name
   * @param leftOut whether a conversation that begins so is not kept
   * @param now simulated time since the platform's clock began
   * @param elsewhere the containers between whose agents nothing is seen
   */
  public MailTraffic(
      String platform,
      Predicate<SentMessage> leftOut,
      Supplier<Duration> now,
      Supplier<List<String>> elsewhere) {
    this.leftOut = leftOut;
    this.now = now;
    this.elsewhere = elsewhere;
    this.documents = new ConversationDocument(platform);
  }

  /** A message was sent; any thread may tell. */
  public synchronized void sent(SentMessage message) {
    String name = nameOf(message);
    if (notKept.containsKey(name)) {
      return;
    }
    if (!ids.containsKey(name) && leftOut.test(message)) {
      notKept.put(name, true);
      return;
    }
    String id = ids.computeIfAbsent(name, fresh -> "C" + ++conversations);
    int length = message.content().length();
    String content = ShownText.cut(message.content(), LONGEST_CONTENT);
    ring.add(
        new Mail(id, message.withContent(content), length, Instant.now(), now.get()),
        content.length());
  }

  /** What names no conversation belongs to the others of the same two agents that name none. */
  private static String nameOf(SentMessage message) {
    return message
        .conversation()
        .orElseGet(
            () ->
                Stream.of(message.sender(), message.receiver())
                    .sorted()
                    .collect(Collectors.joining(" ")));
  }

  @Override
  public long latest() {
    return ring.latest();
  }

  /** The conversations in which something was said meanwhile, the one begun first in front. */
  @Override
  public JsonNode between(long after, long last) {
    JsonMembers document = JsonMembers.empty().words("elsewhere", elsewhere.get());
    document.node().put("oldest", ring.oldest());
    ArrayNode array = document.node().putArray("conversations");
    Set<String> wanted =
        ring.between(after, last).stream()
            .map(kept -> kept.what().conversation())
            .collect(Collectors.toSet());
    for (Conversation conversation : conversations(last)) {
      if (wanted.contains(conversation.id())) {
        array.add(documents.summary(conversation));
      }
    }
    return document.node();
  }

  private List<Conversation> conversations(long last) {
    Map<String, List<Ring.Kept<Mail>>> byId = new LinkedHashMap<>();
    for (Ring.Kept<Mail> kept : ring.between(0, last)) {
      byId.computeIfAbsent(kept.what().conversation(), id -> new ArrayList<>()).add(kept);
    }
    return byId.entrySet().stream()
        .map(entry -> new Conversation(entry.getKey(), entry.getValue()))
        .toList();
  }

  /** One conversation with its messages; empty when none of them is kept any more. */
  public Optional<JsonNode> conversation(String id) {
    return conversations(ring.latest()).stream()
        .filter(conversation -> conversation.id().equals(id))
        .findFirst()
        .map(documents::full);
  }
}
