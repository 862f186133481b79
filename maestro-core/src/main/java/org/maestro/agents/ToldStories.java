package org.maestro.agents;

import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.coordination.Story;
import org.maestro.coordination.StoryEntry;
import org.maestro.sl.Content;

/**
 * The stories of the central agent's goals: told to the archive and to who subscribed, and kept to
 * be asked for. Agent thread only.
 */
final class ToldStories {
  private final MaestroAgent agent;
  private final Story archive;
  private final Consumer<String> ended;
  private final Map<String, List<StoryEntry>> stories = new LinkedHashMap<>();
  private final List<Subscription> subscriptions = new ArrayList<>();

  private record Subscription(String goalId, ACLMessage request) {}

  /**
   * @param past what was told by who was the central agent before
   * @param ended told the id of each goal whose story has come to its end
   */
  ToldStories(
      MaestroAgent agent,
      Story archive,
      Map<String, List<StoryEntry>> past,
      Consumer<String> ended) {
    this.agent = agent;
    this.archive = archive;
    this.ended = ended;
    past.forEach((goal, story) -> stories.put(goal, new ArrayList<>(story)));
  }

  Map<String, List<StoryEntry>> all() {
    return stories;
  }

  Set<String> goals() {
    return stories.keySet();
  }

  void told(StoryEntry entry) {
    archive.tell(entry);
    stories.computeIfAbsent(entry.goalId(), id -> new ArrayList<>()).add(entry);
    subscriptions.stream()
        .filter(s -> s.goalId().equals(entry.goalId()))
        .forEach(s -> inform(s.request(), entry));
    if (entry.kind() == StoryEntry.Kind.END) {
      ended.accept(entry.goalId());
      subscriptions.removeIf(s -> s.goalId().equals(entry.goalId()));
    }
  }

  /** Once, as long as the goal's story is told. */
  void misconduct(String goalId, String sentence) {
    String text = sentence + ".";
    List<StoryEntry> story = stories.getOrDefault(goalId, List.of());
    if (!isOver(story) && story.stream().noneMatch(entry -> entry.text().equals(text))) {
      told(new StoryEntry(goalId, agent.clock().now(), StoryEntry.Kind.MISCONDUCT, text));
    }
  }

  void subscribe(ACLMessage message, Words words) {
    String id = words.string("story").orElse("");
    List<StoryEntry> told = stories.getOrDefault(id, List.of());
    told.forEach(entry -> inform(message, entry));
    if (!isOver(told)) {
      subscriptions.add(new Subscription(id, message));
    }
  }

  private static boolean isOver(List<StoryEntry> story) {
    return !story.isEmpty() && story.get(story.size() - 1).kind() == StoryEntry.Kind.END;
  }

  /** The whole story of a goal that has one. */
  void tellAll(ACLMessage question, String goalId) {
    answer(question, stories.getOrDefault(goalId, List.of()));
  }

  /** Sentences that were not told before, in answer to a question. */
  void tell(ACLMessage question, String goalId, List<String> sentences) {
    answer(
        question,
        sentences.stream()
            .map(text -> new StoryEntry(goalId, agent.clock().now(), StoryEntry.Kind.PLAN, text))
            .toList());
  }

  private void answer(ACLMessage question, List<StoryEntry> entries) {
    agent.reply(
        question,
        ACLMessage.INFORM,
        entries.stream().map(ToldStories::line).toArray(Content[]::new));
  }

  private void inform(ACLMessage subscription, StoryEntry entry) {
    agent.reply(subscription, ACLMessage.INFORM, line(entry));
  }

  private static Content line(StoryEntry entry) {
    return Words.content(
        "inform",
        Words.named("goal", Words.name(entry.goalId())),
        Words.named("at", Words.number(entry.at().toMillis() / 1000.0)),
        Words.named("kind", Words.name(entry.kind().name().toLowerCase())),
        Words.named("text", Words.text(entry.text())));
  }
}
