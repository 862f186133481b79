package org.maestro.agents;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.maestro.agents.centre.GoalRequests;
import org.maestro.agents.centre.Sayings;
import org.maestro.agents.centre.ToldStories;
import org.maestro.agents.centre.Undoing;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.ContractWords;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.goals.OwnGoalRequests;
import org.maestro.agents.goals.OwnGoals;
import org.maestro.agents.goals.Past;
import org.maestro.agents.goals.ReasoningServices;
import org.maestro.agents.lives.AgentLifeListener;
import org.maestro.agents.rooms.RoomListening;
import org.maestro.agents.rooms.RoomSpeech;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.Caller;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.runtime.PartGuard;
import org.maestro.agents.runtime.Spokesmen;
import org.maestro.coordination.api.Stakes;
import org.maestro.coordination.api.Story;
import org.maestro.dialogue.Dialogues;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Part;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Content;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * An agent that stands for several devices and has goals of its own, such as to keep a room lit
 * (Three-layered architecture, 2 and 5.1; M15, M16, M91). All that it is comes from the home's
 * description of the group; it knows of no kind of device. It hears of its members from their
 * agents, watches the collective knowledge, and works also when there is no central agent.
 */
public final class GroupAgent extends MaestroAgent implements AgentLifeListener {
  private static final long serialVersionUID = 1L;

  private static final String KNOWN =
      "inform, yield, cancel, answer, query-ref, subscribe and initCNP";
  private static final String KNOWN_IN_ROOMS =
      "inform, yield, cancel, answer, query-ref, subscribe, initCNP, say and understand";

  /** Members come and go; so often their agents are asked, and the condition is looked at. */
  private static final Duration BETWEEN_ROLL_CALLS = Duration.ofSeconds(60);

  /** Wall time that members have to show up before the first plan. */
  private static final Duration FIRST_MEMBERS = Duration.ofSeconds(10);

  private final transient ReasoningServices mind;
  private final transient Group group;
  private final transient OwnGoals goals;
  private final transient Spokesmen spokesmen;
  private final transient PartGuard parts;

  /** The life in which a member that is there is known: its agent may come to live elsewhere. */
  private final transient Map<String, String> present = new TreeMap<>();

  private transient volatile Set<String> called = Set.of();
  private transient Clock.Timer rollCall = () -> {};
  private transient Clock.Timer start = () -> {};
  private final transient GoalRequests requests;
  private final transient Optional<RoomListening> listening;
  private final transient Optional<RoomSpeech> speech;
  private boolean started;

  /**
   * @param past of the platform, with which its goals go on
   * @param dialogues what persons have said before
   * @param spokesmen who is believed what he reports of members, and needs no permission
   */
  public GroupAgent(
      Birth birth,
      AgentTime time,
      ReasoningServices mind,
      Group group,
      Story story,
      Past past,
      Dialogues dialogues,
      Spokesmen spokesmen) {
    super(birth, time);
    this.mind = mind;
    this.spokesmen = spokesmen;
    this.parts = new PartGuard(this, mind.knowledge()::home, spokesmen);
    this.group = group;
    this.goals =
        new OwnGoals(
            this,
            group.id(),
            time.clock(),
            mind,
            story,
            past,
            member -> called.contains(member),
            Optional.empty());
    this.requests =
        new GoalRequests(
            this,
            mind.knowledge(),
            goals.manager(),
            new ToldStories(this, story, Map.of(), goalId -> {}));
    this.listening = group.hearing().map(hearing -> listening(dialogues));
    this.speech =
        group.hearing().stream()
            .flatMap(hearing -> hearing.rooms().stream())
            .findFirst()
            .map(room -> new RoomSpeech(this, group.id(), room, mind.knowledge()::home, dialogues));
  }

  /** What is said in its room, as the central agent hears it in the whole home. */
  private RoomListening listening(Dialogues dialogues) {
    KnowledgeBase knowledge = mind.knowledge();
    return new RoomListening(
        this,
        group.id(),
        member -> called.contains(member),
        knowledge,
        dialogues,
        new Sayings(
            this,
            knowledge,
            goals.manager(),
            requests,
            new Undoing(this, goals.manager(), requests),
            dialogues,
            goals.faces()),
        goals.faces());
  }

  @Override
  protected void setup() {
    super.setup();
    goals.begin();
    callRoll();
    start = clock().schedule(patience(FIRST_MEMBERS), group.id(), () -> tell(this::startToPursue));
  }

  @Override
  protected void takeDown() {
    rollCall.cancel();
    start.cancel();
    speech.ifPresent(RoomSpeech::end);
    goals.end();
    super.takeDown();
  }

  /** One in the place of another does not know who listened to that one. */
  @Override
  public void agentBegins(String name) {
    if (called.contains(name)) {
      tell(() -> call(name));
    }
  }

  @Override
  public void agentMoves(String name) {
    tell(() -> goals.agentMoves(name));
  }

  @Override
  public void agentEnded(String name) {
    tell(() -> present.keySet().removeAll(goals.agentGone(name, "its agent has ended")));
  }

  @Override
  public void agentStaysAway(String member, String reason) {
    tell(
        () ->
            speech
                .filter(its -> members().contains(member))
                .ifPresent(its -> its.memberStaysAway(member, reason)));
  }

  @Override
  public void agentDied(String name) {
    tell(
        () -> {
          speech.ifPresent(its -> its.agentDied(name));
          if (name.equals(AgentNames.COORDINATOR)) {
            listening.ifPresent(RoomListening::centreDied);
          }
        });
  }

  private void startToPursue() {
    if (!started) {
      started = true;
      start.cancel();
      Substitution self = new Substitution(Self.is(group.id()));
      goals.pursueOnly(
          group.pursues().stream().map(self::apply).toList(),
          Stakes.of(group.worth(), self::apply));
    }
  }

  private void callRoll() {
    Set<String> members = members();
    for (String gone : new TreeSet<>(present.keySet())) {
      if (!members.contains(gone)) {
        present.remove(gone);
        goals.memberLost(gone, "it is none of this group any more");
      }
    }
    called = members;
    speech.ifPresent(its -> its.expect(members));
    members.forEach(this::call);
    rollCall = clock().schedule(BETWEEN_ROLL_CALLS, group.id(), () -> tell(this::callRoll));
  }

  private void call(String member) {
    send(
        message(
            ACLMessage.SUBSCRIBE,
            getAID(member),
            Words.content("subscribe", Words.named("member", Words.name(member)))));
  }

  /** Those stated by name, and all for which the condition is known to hold. */
  private Set<String> members() {
    Set<String> members = new TreeSet<>(group.members());
    Evaluation evaluation = new Evaluation(mind.knowledge().snapshot());
    for (String device : mind.knowledge().home().devices().keySet()) {
      Map<String, Term> bindings = Map.of("member", new Term.Name(device));
      Optional<Formula> condition = group.memberWhen();
      if (condition.filter(c -> evaluation.truth(c, bindings) == Truth.TRUE).isPresent()) {
        members.add(device);
      }
    }
    return members;
  }

  @Override
  protected void received(ACLMessage message) {
    for (Content content : Words.parse(message.getContent())) {
      Words words = Words.of(content);
      Optional<Part> part = part(content.operator());
      if (part.isPresent() && !parts.admits(message, words, part.get())) {
        continue;
      }
      switch (content.operator()) {
        case "inform" -> memberNews(message, words);
        case "yield" -> goals.askedToYield(message, words);
        case "cancel" -> new OwnGoalRequests(this, goals).cancel(message, words);
        case "answer" -> new OwnGoalRequests(this, goals).answer(message, words);
        case "query-ref" -> new OwnGoalRequests(this, goals).list(message);
        case "subscribe" -> goals.centreReturned();
        case "say" -> heard(message, content, its -> its.say(message, words));
        case "initCNP" -> requests.goal(message, words);
        case "understand" -> heard(message, content, its -> its.understand(message, words));
        default -> notUnderstood(message, content);
      }
    }
  }

  private static Optional<Part> part(String operator) {
    return switch (operator) {
      case "initCNP", "cancel", "answer" -> Optional.of(Part.GOALS);
      case "say", "understand" -> Optional.of(Part.UNDERSTANDING);
      case "query-ref" -> Optional.of(Part.STORIES);
      default -> Optional.empty();
    };
  }

  private void heard(ACLMessage message, Content content, Consumer<RoomListening> what) {
    listening.ifPresentOrElse(what, () -> notUnderstood(message, content));
  }

  private void notUnderstood(ACLMessage message, Content content) {
    refuse(
        message,
        ACLMessage.NOT_UNDERSTOOD,
        "%s does not know the operator %s; it knows %s."
            .formatted(
                group.id(),
                Replies.shortened(content.operator()),
                listening.isPresent() ? KNOWN_IN_ROOMS : KNOWN));
  }

  /** An agent speaks of its own member only; that one is gone the supervisor may say as well. */
  private void memberNews(ACLMessage message, Words words) {
    String member = words.string("member").orElse("");
    Caller caller = Caller.of(message);
    boolean isLost = words.string("phase").filter("lost"::equals).isPresent();
    boolean isOfTheSupervisor = isLost && caller.agent().equals(AgentNames.SUPERVISOR);
    if (!called.contains(member)
        || !isOfTheSupervisor && spokesmen.objection(caller, member).isPresent()) {
      return;
    }
    if (ContractWords.areIn(words)) {
      goals.heard(words);
    } else if (words.string("phase").filter("ready"::equals).isPresent()) {
      String life = words.string("life").orElse("");
      String former = present.put(member, life);
      if (former != null && !former.equals(life)) {
        goals.memberLost(member, "it or its agent was started again");
      }
      if (!life.equals(former) || !goals.isPresent(member)) {
        goals.memberPresent(member, message.getSender(), words.string("life"));
      }
      speech.ifPresent(its -> its.memberPresent(member, message.getSender(), life));
      if (present.keySet().containsAll(called)) {
        startToPursue();
      }
    } else if (present.remove(member) != null) {
      goals.memberLost(member, words.string("reason").orElse("lost"));
      speech.ifPresent(its -> its.memberLost(member, words.string("reason").orElse("lost")));
    }
  }
}
