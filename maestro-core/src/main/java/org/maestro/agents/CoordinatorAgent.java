package org.maestro.agents;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentSkipListSet;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.HeldNews;
import org.maestro.coordination.InvalidGoalException;
import org.maestro.coordination.Journal;
import org.maestro.coordination.Recovery;
import org.maestro.coordination.Story;
import org.maestro.coordination.StoryEntry;
import org.maestro.knowledge.KnowledgeBase;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.planning.Planner;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The Central Coordination Agent (M76): takes goals by FIPA request, and is the coordinator's voice
 * and ear. It answers {@code initCNP}, {@code cancel}, {@code explain}, {@code subscribe} and
 * {@code query-ref} about goals.
 */
public final class CoordinatorAgent extends MaestroAgent {
  private static final long serialVersionUID = 1L;
  private static final Logger LOG = LoggerFactory.getLogger(CoordinatorAgent.class);

  /** Wall time that members have to show up again after a restart. */
  private static final Duration COMEBACK = Duration.ofSeconds(10);

  /** The paper's name of this agent. */
  public static final String NAME = "CCA";

  private final transient KnowledgeBase knowledge;
  private final transient Deliberation deliberation;
  private final transient Coordinator coordinator;
  private final transient Story archive;
  private final transient Recovery recovery;
  private final transient boolean returns;
  private final transient Map<String, GoalOfAnother> goalsOfOthers = new LinkedHashMap<>();
  private final transient Journal journal;
  private final transient Endings endings = new Endings(this::reply);
  private final transient Map<String, List<StoryEntry>> stories = new LinkedHashMap<>();
  private final transient Set<String> present = new ConcurrentSkipListSet<>();
  private final transient List<Subscription> subscriptions = new ArrayList<>();

  /** A goal that an agent pursues of its own accord, as it last told of it. */
  private record GoalOfAnother(AID owner, Content status) {}

  private record Subscription(String goalId, ACLMessage request) {}

  /** A coordinator that remembers nothing, and is remembered by nobody. */
  public CoordinatorAgent(
      AgentTime time,
      KnowledgeBase knowledge,
      Planner planner,
      Story archive,
      Duration decisionTime) {
    this(time, knowledge, planner, archive, decisionTime, Past.none());
  }

  /**
   * @param archive where stories are kept beyond this agent's life
   * @param decisionTime simulated time that a decision takes; zero on a paced clock
   * @param past what it goes on from
   */
  public CoordinatorAgent(
      AgentTime time,
      KnowledgeBase knowledge,
      Planner planner,
      Story archive,
      Duration decisionTime,
      Past past) {
    super(time);
    this.knowledge = knowledge;
    this.archive = archive;
    this.recovery = past.recovery();
    this.returns = past.returns();
    this.journal = new AgentJournal(this, time.clock(), past.journal());
    past.stories().forEach((goal, story) -> stories.put(goal, new ArrayList<>(story)));
    this.deliberation =
        new Deliberation(
            this,
            time.clock(),
            new Mind(knowledge, planner, decisionTime),
            this::told,
            journal,
            this::misconduct);
    this.coordinator = deliberation.coordinator();
  }

  /** The members that can be used now. Any thread may ask. */
  public Collection<String> presentMembers() {
    return List.copyOf(present);
  }

  /**
   * The member's agent ended here and is to begin elsewhere, where it announces itself. Any thread
   * may call.
   */
  public void agentMoves(String member) {
    tell(() -> agentGone(member, "its agent moves to another container"));
  }

  /** The member's agent is no more, killed or with its container. Any thread may call. */
  public void agentEnded(String member) {
    tell(() -> agentGone(member, "its agent has ended"));
  }

  /** Orders that no report has come for yet. */
  int ordersUnderway() {
    return deliberation.ordersUnderway();
  }

  /** Whether anything is known of parts awarded for goals that are not over. */
  boolean contractsOpen() {
    return deliberation.contractsOpen();
  }

  private void agentGone(String member, String reason) {
    if (deliberation.agentGone(member, reason)) {
      present.remove(member);
    }
  }

  @Override
  protected void setup() {
    super.setup();
    deliberation.begin();
    if (returns) {
      callRoll();
    }
    Map<String, Formula> goals = new HashMap<>();
    recovery.goals().forEach(goal -> goals.put(goal.id(), goal.request().goal()));
    recovery.ended().forEach(goal -> endings.ended(goal.request().goal(), goal.outcome()));
    coordinator.resume(
        recovery, patience(COMEBACK), outcome -> endings.ended(goals.get(outcome.id()), outcome));
  }

  /** The agents of another coordinator's time tell who is there, as they did then. */
  private void callRoll() {
    Set<String> names = new TreeSet<>(knowledge.home().devices().keySet());
    names.addAll(knowledge.home().groups().keySet());
    for (String name : names) {
      send(
          message(
              ACLMessage.SUBSCRIBE,
              getAID(name),
              Words.content("subscribe", Words.named("member", Words.name(name)))));
    }
  }

  /** What was told so far, by the goal's id. To be asked for when the agent has ended. */
  public Map<String, List<StoryEntry>> stories() {
    return stories;
  }

  @Override
  protected void takeDown() {
    super.takeDown();
    deliberation.end();
  }

  @Override
  protected void received(ACLMessage message) {
    for (Content content : Words.parse(message.getContent())) {
      Words words = Words.of(content);
      switch (content.operator()) {
        case "initCNP" -> goal(message, words);
        case "inform" -> memberNews(message, words, content);
        case "cancel" -> cancel(message, words);
        case "explain" -> explain(message, words);
        case "subscribe" -> subscribe(message, words);
        case "query-ref" -> list(message, words);
        case "await" -> await(message, words);
        default ->
            refuse(
                message,
                ACLMessage.NOT_UNDERSTOOD,
                "The CCA does not know the operator "
                    + Replies.shortened(content.operator())
                    + "; it knows initCNP, await, cancel, explain, subscribe and query-ref.");
      }
    }
  }

  private void goal(ACLMessage message, Words words) {
    if (message.getPerformative() != ACLMessage.REQUEST) {
      refuse(
          message,
          ACLMessage.NOT_UNDERSTOOD,
          "initCNP is understood in a request only, and this message is another: "
              + ACLMessage.getPerformative(message.getPerformative())
              + ".");
      return;
    }
    Formula goal = words.find("goal").map(this::formula).orElse(null);
    if (goal == null) {
      refuse(
          message,
          ACLMessage.NOT_UNDERSTOOD,
          "initCNP needs a goal, such as (initCNP (:goal (nextTo Cup Bob))).");
      return;
    }
    String requester = message.getSender().getLocalName();
    try {
      String id =
          coordinator.submit(
              GoalWords.request(goal, requester, words, clock().now()),
              news -> answer(message, news),
              outcome -> endings.ended(goal, outcome));
      journal.afterwards(
          () -> {
            reply(
                message,
                ACLMessage.AGREE,
                Words.content("initCNP", Words.named("goal", Words.name(id))));
            endings.await(id, message);
          });
    } catch (InvalidGoalException e) {
      refuse(message, ACLMessage.REFUSE, e.getMessage());
    }
  }

  /** A goal is a formula, or its text; a class atom may have been read as a term. */
  private Formula formula(Words words) {
    return words
        .formula()
        .or(() -> words.terms().stream().findFirst().map(t -> parse(Words.plain(t))))
        .orElse(null);
  }

  private Formula parse(String text) {
    return SlParser.formula(
        text,
        name ->
            knowledge
                .home()
                .vocabulary()
                .predicate(name)
                .filter(PredicateDeclaration::fluent)
                .isPresent());
  }

  /** The end of a goal, for who did not state it, or whose conversation ended with a process. */
  private void await(ACLMessage message, Words words) {
    String id = words.string("goal").orElse("");
    if (!endings.isOver(id)) {
      if (!coordinator.hasGoal(id)) {
        refuse(message, ACLMessage.REFUSE, noSuchGoal(id));
        return;
      }
      reply(message, ACLMessage.AGREE, Words.content("await", Words.named("goal", Words.name(id))));
    }
    endings.await(id, message);
  }

  /**
   * Of a held goal, each time that it begins or ceases to be so: it is confirmed or disconfirmed.
   */
  private void answer(ACLMessage message, HeldNews news) {
    reply(
        message,
        news.kind().isSo() ? ACLMessage.CONFIRM : ACLMessage.DISCONFIRM,
        GoalWords.news(news));
  }

  private void memberNews(ACLMessage message, Words words, Content whole) {
    Optional<String> member = words.string("member");
    Optional<String> phase = words.string("phase");
    if (member.isPresent() && phase.isPresent()) {
      if (phase.get().equals("ready")) {
        deliberation.memberPresent(member.get(), message.getSender(), words.string("life"));
        present.add(member.get());
      } else {
        present.remove(member.get());
        deliberation.memberLost(member.get(), words.string("reason").orElse("lost"));
      }
    } else if (words.string("goal").isPresent() && words.string("state").isPresent()) {
      goalsOfOthers.put(words.string("goal").get(), new GoalOfAnother(message.getSender(), whole));
    } else {
      refuse(
          message,
          ACLMessage.NOT_UNDERSTOOD,
          "The CCA is informed of members only: (inform (:member NAME) (:phase ready)).");
    }
  }

  private void cancel(ACLMessage message, Words words) {
    String id = words.string("goal").orElse("");
    if (goalsOfOthers.containsKey(id)) {
      ask(
          message(
              ACLMessage.REQUEST,
              goalsOfOthers.get(id).owner(),
              Words.content("cancel", Words.named("goal", Words.name(id)))),
          patience(patience().agreement()),
          answer ->
              reply(
                  message,
                  answer.getPerformative(),
                  Words.parse(answer.getContent()).toArray(Content[]::new)));
      return;
    }
    if (coordinator.cancel(id, message.getSender().getLocalName())) {
      reply(
          message,
          ACLMessage.INFORM,
          Words.content("inform", Words.named("cancelled", Words.name(id))));
    } else {
      refuse(
          message,
          ACLMessage.REFUSE,
          stories.containsKey(id) ? "The goal " + id + " has ended already." : noSuchGoal(id));
    }
  }

  private void explain(ACLMessage message, Words words) {
    String id = words.string("goal").orElse("");
    List<StoryEntry> story = stories.get(id);
    if (story == null) {
      refuse(message, ACLMessage.REFUSE, noSuchGoal(id));
    } else if (words.find("step").isPresent()) {
      coordinator.explainChoice(
          id,
          (int) words.number("step", 0),
          sentences ->
              reply(
                  message,
                  ACLMessage.INFORM,
                  sentences.stream()
                      .map(text -> new StoryEntry(id, clock().now(), StoryEntry.Kind.PLAN, text))
                      .map(CoordinatorAgent::line)
                      .toArray(Content[]::new)));
    } else {
      reply(
          message,
          ACLMessage.INFORM,
          story.stream().map(CoordinatorAgent::line).toArray(Content[]::new));
    }
  }

  private void subscribe(ACLMessage message, Words words) {
    String id = words.string("story").orElse("");
    List<StoryEntry> told = stories.getOrDefault(id, List.of());
    told.forEach(entry -> inform(message, entry));
    if (told.isEmpty() || told.get(told.size() - 1).kind() != StoryEntry.Kind.END) {
      subscriptions.add(new Subscription(id, message));
    }
  }

  /** The goals, or with {@code (query-ref waits)} the wait-for graph. */
  private void list(ACLMessage message, Words words) {
    boolean waits = words.terms().contains(new Term.Name("waits"));
    List<Content> lines = new ArrayList<>();
    if (waits) {
      coordinator.waits().forEach(wait -> lines.add(GoalWords.wait(wait)));
    } else {
      coordinator.goals().forEach(goal -> lines.add(GoalWords.status(goal)));
      goalsOfOthers.values().forEach(other -> lines.add(other.status()));
    }
    reply(message, ACLMessage.INFORM, lines.toArray(Content[]::new));
  }

  private String noSuchGoal(String id) {
    return stories.isEmpty()
        ? "There is no goal " + id + "; none was stated yet."
        : "There is no goal " + id + "; there are " + String.join(", ", stories.keySet()) + ".";
  }

  /** Into the log always, into the goal's story once, as long as it is told. */
  private void misconduct(String goalId, String sentence) {
    LOG.warn("{}: {}", goalId, sentence);
    List<StoryEntry> story = stories.getOrDefault(goalId, List.of());
    boolean isOver = !story.isEmpty() && story.get(story.size() - 1).kind() == StoryEntry.Kind.END;
    String text = sentence + ".";
    if (!isOver && story.stream().noneMatch(entry -> entry.text().equals(text))) {
      told(new StoryEntry(goalId, clock().now(), StoryEntry.Kind.MISCONDUCT, text));
    }
  }

  private void told(StoryEntry entry) {
    archive.tell(entry);
    stories.computeIfAbsent(entry.goalId(), id -> new ArrayList<>()).add(entry);
    subscriptions.stream()
        .filter(s -> s.goalId().equals(entry.goalId()))
        .forEach(s -> inform(s.request(), entry));
    if (entry.kind() == StoryEntry.Kind.END) {
      deliberation.forget(entry.goalId());
      subscriptions.removeIf(s -> s.goalId().equals(entry.goalId()));
    }
  }

  private void inform(ACLMessage subscription, StoryEntry entry) {
    reply(subscription, ACLMessage.INFORM, line(entry));
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
