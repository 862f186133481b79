package org.maestro.agents;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentSkipListSet;
import org.maestro.agents.centre.DeploymentRequests;
import org.maestro.agents.centre.GoalRequests;
import org.maestro.agents.centre.HomeRules;
import org.maestro.agents.centre.HostedReasoners;
import org.maestro.agents.centre.Reporters;
import org.maestro.agents.centre.Sayings;
import org.maestro.agents.centre.ToldStories;
import org.maestro.agents.centre.Undoing;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.ContractWords;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.faces.Faces;
import org.maestro.agents.goals.AgentJournal;
import org.maestro.agents.goals.Deliberation;
import org.maestro.agents.goals.Past;
import org.maestro.agents.goals.ReasoningServices;
import org.maestro.agents.lives.AgentLifeListener;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.runtime.PartGuard;
import org.maestro.agents.runtime.Spokesmen;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.Reasoner;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Story;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.dialogue.Dialogues;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.Part;
import org.maestro.planning.api.Planner;
import org.maestro.sl.Content;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The Central Coordination Agent (Three-layered architecture, 3.3.3; M76): takes goals by FIPA
 * request, and is the coordinator's voice and ear. It answers {@code initCNP}, {@code cancel},
 * {@code undo}, {@code say}, {@code explain}, {@code subscribe} and {@code query-ref} about goals
 * and their plans.
 */
public final class CoordinatorAgent extends MaestroAgent implements AgentLifeListener {
  private static final long serialVersionUID = 1L;
  private static final Logger LOG = LoggerFactory.getLogger(CoordinatorAgent.class);

  /** Wall time that members have to show up again after a restart. */
  private static final Duration COMEBACK = Duration.ofSeconds(10);

  /** What agents of other platforms may ask for. */
  private static final Set<String> FOR_ALL =
      Set.of("initCNP", "await", "cancel", "explain", "subscribe", "query-ref");

  /** The paper's name of this agent. */
  private final transient KnowledgeBase knowledge;

  private final transient Deliberation deliberation;
  private final transient Coordinator coordinator;
  private final transient Recovery recovery;
  private final transient boolean returns;
  private final transient ToldStories stories;
  private final transient GoalRequests requests;
  private final transient Undoing undoing;
  private final transient Sayings sayings;
  private final transient HomeRules rules;
  private final transient HostedReasoners reasoners;
  private final transient Reporters reporters;
  private final transient PartGuard parts;
  private final transient DeploymentRequests deployment = new DeploymentRequests(this);
  private final transient Set<String> present = new ConcurrentSkipListSet<>();

  /**
   * @param archive where stories are kept beyond this agent's life
   * @param decisionTime simulated time that a decision takes; zero on a paced clock
   * @param past what it goes on from
   * @param dialogues what persons have said before
   * @param reasoners of others that say which goals they want
   * @param spokesmen who is believed what he reports of members, and needs no permission
   */
  public CoordinatorAgent(
      Birth birth,
      AgentTime time,
      KnowledgeBase knowledge,
      Planner planner,
      Story archive,
      Duration decisionTime,
      Past past,
      Dialogues dialogues,
      List<Reasoner> reasoners,
      Spokesmen spokesmen) {
    super(birth, time);
    this.knowledge = knowledge;
    this.recovery = past.recovery();
    this.returns = past.returns();
    Journal journal = new AgentJournal(this, time.clock(), past.journal());
    this.stories = new ToldStories(this, archive, past.stories(), this::storyEnded);
    Faces faces = new Faces(this, AgentNames.COORDINATOR, knowledge);
    this.deliberation =
        new Deliberation(
            this,
            time.clock(),
            new ReasoningServices(knowledge, planner, decisionTime),
            stories::told,
            journal,
            this::misconduct,
            faces);
    this.coordinator = deliberation.coordinator();
    this.requests = new GoalRequests(this, knowledge, coordinator, stories);
    this.undoing = new Undoing(this, coordinator, requests);
    this.sayings = new Sayings(this, knowledge, coordinator, requests, undoing, dialogues, faces);
    this.rules = new HomeRules(this, knowledge.home(), requests);
    this.reasoners = new HostedReasoners(this, knowledge, reasoners, requests);
    this.reporters = new Reporters(this, spokesmen);
    this.parts = new PartGuard(this, knowledge::home, spokesmen);
  }

  /** The members that can be used now. Any thread may ask. */
  public Collection<String> presentMembers() {
    return List.copyOf(present);
  }

  @Override
  public void agentMoves(String name) {
    tell(() -> present.removeAll(deliberation.agentMoves(name)));
  }

  @Override
  public void agentStaysAway(String member, String reason) {
    tell(() -> deliberation.agentStaysAway(member, reason));
  }

  @Override
  public void agentDoubted(String name, String reason) {
    tell(
        () ->
            deliberation
                .membersOf(name)
                .forEach(member -> deliberation.agentDoubted(member, reason)));
  }

  @Override
  public void agentTrusted(String name) {
    tell(() -> deliberation.membersOf(name).forEach(deliberation::agentTrusted));
  }

  @Override
  public void agentEnded(String name) {
    tell(() -> agentGone(name, "its agent has ended"));
  }

  /** Orders that no report has come for yet. */
  int ordersUnderway() {
    return deliberation.ordersUnderway();
  }

  /** Whether anything is known of parts awarded for goals that are not over. */
  boolean contractsOpen() {
    return deliberation.contractsOpen();
  }

  private void agentGone(String name, String reason) {
    present.removeAll(deliberation.agentGone(name, reason));
  }

  @Override
  protected void setup() {
    super.setup();
    deliberation.begin();
    if (returns) {
      callRoll();
    }
    requests.takeUp(recovery);
    coordinator.resume(recovery, patience(COMEBACK), requests::ended);
    rules.begin(patience(COMEBACK));
    reasoners.begin(recovery);
  }

  /** The agents of another coordinator's time tell who is there, as they did then. */
  private void callRoll() {
    Set<String> names = new TreeSet<>(knowledge.home().devices().keySet());
    names.addAll(knowledge.home().groups().keySet());
    callRoll(names);
  }

  /** These agents, too, are asked which members are there. Any thread may call. */
  public void ask(Collection<String> agents) {
    tell(() -> callRoll(agents));
  }

  private void callRoll(Collection<String> names) {
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
    return stories.all();
  }

  @Override
  protected void takeDown() {
    super.takeDown();
    deliberation.end();
  }

  /** Agents of other platforms ask it for goals, as those of its own do. */
  @Override
  protected boolean hearsOtherPlatforms() {
    return true;
  }

  @Override
  protected void received(ACLMessage message) {
    for (Content content : Words.parse(message.getContent())) {
      Words words = Words.of(content);
      if (isFromOtherPlatform(message) && !FOR_ALL.contains(content.operator())) {
        refuse(
            message,
            ACLMessage.REFUSE,
            "The CCA lets agents of other platforms state goals, follow and cancel their own, and"
                + " list them; "
                + Replies.shortened(content.operator())
                + " is for its own platform.");
        continue;
      }
      Optional<Part> part = part(content.operator());
      if (part.isPresent() && !parts.admits(message, words, part.get())) {
        continue;
      }
      switch (content.operator()) {
        case "initCNP" -> requests.goal(message, words);
        case "inform" -> {
          if (reporters.areHeard(message, words, knowledge.home(), coordinator, stories)) {
            memberNews(message, words, content);
          }
        }
        case "yield" -> deliberation.askedToYield(message, words);
        case "cancel" -> requests.cancel(message, words);
        case "undo" -> undoing.undo(message, words);
        case "answer" -> requests.answer(message, words);
        case "say" -> sayings.say(message, words);
        case "explain" -> requests.explain(message, words);
        case "subscribe" -> requests.subscribe(message, words);
        case "query-ref" -> {
          if (words.string("before").isPresent()) {
            undoing.before(message, words);
          } else {
            requests.list(message, words);
          }
        }
        case "await" -> requests.await(message, words);
        case "perform" -> deployment.forward(message, content);
        default ->
            refuse(
                message,
                ACLMessage.NOT_UNDERSTOOD,
                "The CCA does not know the operator "
                    + Replies.shortened(content.operator())
                    + "; it knows initCNP, await, cancel, undo, answer, say, explain, subscribe,"
                    + " query-ref and perform.");
      }
    }
  }

  private static Optional<Part> part(String operator) {
    return switch (operator) {
      case "initCNP", "cancel", "undo", "answer", "await" -> Optional.of(Part.GOALS);
      case "say" -> Optional.of(Part.UNDERSTANDING);
      case "explain", "subscribe", "query-ref" -> Optional.of(Part.STORIES);
      case "perform" -> Optional.of(Part.ADMINISTRATION);
      default -> Optional.empty();
    };
  }

  private void memberNews(ACLMessage message, Words words, Content whole) {
    Optional<String> member = words.string("member");
    Optional<String> phase = words.string("phase");
    Optional<String> alert = words.string("alert");
    if (member.isPresent() && alert.isPresent()) {
      misconduct(
          words.string("goal").orElse("none"),
          "%s raises an alarm: %s".formatted(member.get(), alert.get().replaceAll("\\.$", "")));
    } else if (member.isPresent() && ContractWords.areIn(words)) {
      ContractWords.tell(words, deliberation.coordinator());
    } else if (member.isPresent() && phase.isPresent()) {
      if (phase.get().equals("ready")) {
        deliberation.memberPresent(member.get(), message.getSender(), words.string("life"));
        present.add(member.get());
        rules.memberPresent(member.get());
      } else {
        present.remove(member.get());
        deliberation.memberLost(member.get(), words.string("reason").orElse("lost"));
      }
    } else if (words.string("goal").isPresent() && words.string("state").isPresent()) {
      requests.goalOfAnother(message, words, whole);
    } else {
      refuse(
          message,
          ACLMessage.NOT_UNDERSTOOD,
          "The CCA is informed of members only: (inform (:member NAME) (:phase ready)).");
    }
  }

  private void storyEnded(String goalId) {
    deliberation.forget(goalId);
  }

  /** Into the log always, into the goal's story once, as long as it is told. */
  private void misconduct(String goalId, String sentence) {
    LOG.warn("{}: {}", goalId, sentence);
    stories.misconduct(goalId, sentence);
  }
}
