package org.maestro.console.trace;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.time.Instant;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.console.documents.ShownText;
import org.maestro.console.traffic.CallMessages;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.platform.jade.SentMessage;
import org.maestro.rats.bounded.BoundedMap;

/**
 * The traces of the latest goals. A goal's id is the id of its trace: stories and calls have it as
 * such, agents name it as {@code :goal} where they begin to speak, and what answers them or a call
 * is found by its conversation or its call. Any thread may tell and ask.
 */
public final class Traces {
  private static final int MOST_GOALS = 100;
  private static final int MOST_ENTRIES = 400;
  private static final int MOST_LINKS = 10_000;
  private static final int MOST_CHARACTERS = 200;
  private static final Pattern GOAL = Pattern.compile("\\(:goal ([A-Za-z][\\w.-]*)");
  private static final Pattern CALL = Pattern.compile("\\(:call \"([^\"]*)\"");

  private static final Set<String> QUESTIONS = Set.of("query-ref", "query-if", "subscribe");
  private static final String STORY_ASKED_FOR = "(explain ";

  private final String own;
  private final Supplier<Duration> now;

  // All below is guarded by this.
  private final Map<String, GoalTrace> traces = BoundedMap.ofLatelyUsed(MOST_GOALS);
  private final Map<String, String> goalOfConversation = BoundedMap.ofLatelyUsed(MOST_LINKS);
  private final Map<String, Boolean> questions = BoundedMap.ofLatelyUsed(MOST_LINKS);
  private final Map<String, String> goalOfCall = BoundedMap.ofLatelyUsed(MOST_LINKS);

  /**
   * @param platform its name
   * @param now simulated time since the platform's clock began
   */
  public Traces(String platform, Supplier<Duration> now) {
    this.own = "@" + platform;
    this.now = now;
  }

  /** A sentence of a story. */
  public synchronized void told(StoryEntry entry) {
    of(entry.goalId())
        .add(
            TraceEntry.of(
                TraceEntry.Layer.STORY,
                entry.kind().name().toLowerCase(Locale.ROOT),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                entry.text(),
                entry.at(),
                Instant.now()));
  }

  /** A message between agents; who asks how a goal fares adds nothing to it. */
  public synchronized void sent(SentMessage message) {
    String conversation = message.conversation().orElse("");
    if (QUESTIONS.contains(message.performative())
        || message.content().startsWith(STORY_ASKED_FOR)) {
      questions.put(conversation, true);
    }
    if (!conversation.isEmpty() && questions.containsKey(conversation)) {
      return;
    }
    Optional<String> goal =
        first(GOAL, message.content())
            .or(() -> message.conversation().map(goalOfConversation::get));
    if (goal.isEmpty()) {
      return;
    }
    message.conversation().ifPresent(id -> goalOfConversation.put(id, goal.get()));
    Optional<String> call = first(CALL, message.content());
    call.ifPresent(id -> goalOfCall.put(id, goal.get()));
    TraceEntry entry =
        TraceEntry.of(
            TraceEntry.Layer.AGENTS,
            message.performative(),
            Optional.of(named(message.sender())),
            Optional.of(named(message.receiver())),
            call,
            shown(message.content()),
            now.get(),
            Instant.now());
    if (message.conversation().isPresent()) {
      of(goal.get()).add(entry);
    } else {
      of(goal.get()).addRepeated(entry);
    }
  }

  /** A message of the bus that belongs to a call. */
  public synchronized void heard(CallMessages.Said said) {
    said.goal().ifPresent(goal -> goalOfCall.put(said.call(), goal));
    String goal = goalOfCall.get(said.about());
    if (goal == null) {
      return;
    }
    goalOfCall.put(said.call(), goal);
    TraceEntry entry =
        TraceEntry.of(
            TraceEntry.Layer.BUS,
            said.kind(),
            Optional.of(said.from()),
            said.to(),
            Optional.of(said.call()),
            shown(said.text()),
            now.get(),
            Instant.now());
    if (said.isOneOfMany()) {
      of(goal).addRepeated(entry);
    } else {
      of(goal).add(entry);
    }
  }

  private GoalTrace of(String goal) {
    return traces.computeIfAbsent(GoalId.whole(goal), fresh -> new GoalTrace(MOST_ENTRIES));
  }

  private static Optional<String> first(Pattern pattern, String text) {
    Matcher found = pattern.matcher(text);
    return found.find() ? Optional.of(found.group(1)) : Optional.empty();
  }

  private static String shown(String text) {
    return ShownText.cut(ShownText.of(text), MOST_CHARACTERS);
  }

  private String named(String agent) {
    return agent.endsWith(own) ? agent.substring(0, agent.length() - own.length()) : agent;
  }

  /** What is kept of one; empty when nothing is. */
  public synchronized Optional<JsonNode> trace(String goal) {
    return Optional.ofNullable(traces.get(goal)).map(trace -> TraceDocument.of(goal, trace));
  }
}
