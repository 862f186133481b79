package org.maestro.agents.centre;

import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.Latest;
import org.maestro.coordination.api.Story;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.sl.Content;

/**
 * The stories of the central agent's goals: told to the archive and to who subscribed, and kept to
 * be asked for. Agent thread only.
 */
public final class ToldStories {
  private final MaestroAgent agent;
  private final Story archive;
  private final Consumer<String> ended;
  private final Map<String, List<StoryEntry>> running = new LinkedHashMap<>();
  private final Latest<List<StoryEntry>> over = new Latest<>(MOST_BYTES, ToldStories::bytes);
  private final List<Subscription> subscriptions = new ArrayList<>();

  private static final long MOST_BYTES = 1 << 20;
  private static final long MOST_BYTES_OF_EACH = 256 << 10;
  private static final long BYTES_OF_AN_ENTRY = 160;

  private record Subscription(String goalId, ACLMessage request, Supplier<ReadingRights> rights) {}

  /**
   * @param past what was told by who was the central agent before
   * @param ended told the id of each goal whose story has come to its end
   */
  public ToldStories(
      MaestroAgent agent,
      Story archive,
      Map<String, List<StoryEntry>> past,
      Consumer<String> ended) {
    this.agent = agent;
    this.archive = archive;
    this.ended = ended;
    past.forEach(
        (goal, story) -> {
          if (isOver(story)) {
            over.put(goal, new ArrayList<>(story));
          } else {
            running.put(goal, new ArrayList<>(story));
          }
        });
  }

  private static long bytes(List<StoryEntry> story) {
    return story.stream().mapToLong(entry -> BYTES_OF_AN_ENTRY + entry.text().length()).sum();
  }

  public Map<String, List<StoryEntry>> all() {
    Map<String, List<StoryEntry>> all = new LinkedHashMap<>();
    over.ids().forEach(goal -> all.put(goal, story(goal)));
    all.putAll(running);
    return all;
  }

  Set<String> goals() {
    return all().keySet();
  }

  private List<StoryEntry> story(String goalId) {
    return Optional.ofNullable(running.get(goalId)).or(() -> over.find(goalId)).orElse(List.of());
  }

  public void told(StoryEntry entry) {
    archive.tell(entry);
    note(entry);
    subscriptions.stream()
        .filter(s -> s.goalId().equals(entry.goalId()))
        .filter(s -> s.rights().get().objection(entry.privateWords()).isEmpty())
        .forEach(s -> inform(s.request(), entry));
    if (entry.kind() == StoryEntry.Kind.END) {
      ended.accept(entry.goalId());
      subscriptions.removeIf(s -> s.goalId().equals(entry.goalId()));
    }
  }

  /**
   * Stories of goals that are over are kept as long as there is room; of one that is held for long,
   * what the goal is, and the latest.
   */
  private void note(StoryEntry entry) {
    String goalId = entry.goalId();
    Optional<List<StoryEntry>> ended = over.find(goalId);
    List<StoryEntry> story =
        ended.isPresent()
            ? new ArrayList<>(ended.get())
            : running.computeIfAbsent(goalId, id -> new ArrayList<>());
    story.add(entry);
    while (story.size() > 2 && bytes(story) > MOST_BYTES_OF_EACH) {
      story.remove(1);
    }
    if (entry.kind() == StoryEntry.Kind.END || ended.isPresent()) {
      running.remove(goalId);
      over.put(goalId, story);
    }
  }

  /** Once, as long as the goal's story is told. */
  public void misconduct(String goalId, String sentence) {
    String text = sentence + ".";
    List<StoryEntry> story = story(goalId);
    if (!isOver(story) && story.stream().noneMatch(entry -> entry.text().equals(text))) {
      told(
          new StoryEntry(goalId, agent.clock().now(), StoryEntry.Kind.MISCONDUCT, text)
              .using(privateWords(goalId)));
    }
  }

  /** Those that its goal uses. */
  Set<String> privateWords(String goalId) {
    return story(goalId).stream().findFirst().map(StoryEntry::privateWords).orElse(Set.of());
  }

  /**
   * @param rights of who subscribes, as they are at the time
   */
  void subscribe(ACLMessage message, String id, Supplier<ReadingRights> rights) {
    List<StoryEntry> told = story(id);
    told.forEach(entry -> inform(message, entry));
    if (!isOver(told)) {
      subscriptions.add(new Subscription(id, message, rights));
    }
  }

  private static boolean isOver(List<StoryEntry> story) {
    return !story.isEmpty() && story.get(story.size() - 1).kind() == StoryEntry.Kind.END;
  }

  /** The whole story of a goal that has one. */
  void tellAll(ACLMessage question, String goalId) {
    answer(question, story(goalId));
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
        Words.named("kind", Words.name(entry.kind().name().toLowerCase(Locale.ROOT))),
        Words.named("text", Words.text(entry.text())));
  }
}
