package org.maestro.agents;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import jade.wrapper.AgentContainer;
import jade.wrapper.AgentController;
import jade.wrapper.ControllerException;
import jade.wrapper.StaleProxyException;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import org.awaitility.Awaitility;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.goals.Past;
import org.maestro.agents.goals.ReasoningServices;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.runtime.Spokesmen;
import org.maestro.coordination.api.Reasoner;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.dialogue.Dialogues;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.OptimalPlanner;
import org.maestro.platform.BareJade;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.SlParser;

/**
 * A CCA and a desk among actors, on a stepped clock of their own: how long something takes is
 * simulated time, whatever the machine does.
 */
public final class Society implements AutoCloseable {
  /** Simulated time that passes before what failed is tried once more and the goal given up. */
  static final Duration BEFORE_THE_LAST_TRY = Duration.ofSeconds(15);

  private static final int MOST_LOOKS = 10;
  private static final Duration LONGEST = Duration.ofMinutes(20);
  private static final Home HOME = home();

  final SteppedClock clock = new SteppedClock();
  public final AgentTime time = AgentTime.of(clock);
  final List<StoryEntry> story = Collections.synchronizedList(new ArrayList<>());
  public final CoordinatorAgent cca;
  private final CollectiveKnowledge knowledge = new CollectiveKnowledge(HOME, clock);
  public final DeskAgent desk;
  private final AgentContainer container;
  private final Map<String, AgentController> controllers = new LinkedHashMap<>();
  private final int behavioursOfCca;

  public Society(BareJade jade) {
    this(jade, List.of());
  }

  /** One that hosts reasoners of others. */
  Society(BareJade jade, List<Reasoner> reasoners) {
    container = jade.main();
    desk = new DeskAgent(birth(), time);
    cca =
        new CoordinatorAgent(
            birth(),
            time,
            knowledge,
            new OptimalPlanner(),
            story::add,
            Duration.ofMillis(20),
            Past.none(),
            new Dialogues(knowledge::home, knowledge::snapshot, clock::instant),
            reasoners,
            Spokesmen.BY_NAME);
    start(container, AgentNames.COORDINATOR, cca);
    start(container, "desk", desk);
    behavioursOfCca = cca.behaviourCount();
  }

  private static Home home() {
    try (InputStream turtle = Society.class.getResourceAsStream("/greeters.ttl")) {
      return new HomeLoader()
          .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "greeters.ttl");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** How a goal ended. */
  record Outcome(ACLMessage reply, Duration took) {
    boolean reached() {
      return reply.getPerformative() == ACLMessage.INFORM;
    }
  }

  /** Of one agent of this society. */
  Birth birth() {
    return Birth.of(container);
  }

  private void start(AgentContainer where, String name, MaestroAgent agent) {
    controllers.put(name, BareJade.start(where, name, agent));
  }

  public void start(String name, MaestroAgent agent) {
    start(container, name, agent);
  }

  /** An agent with goals of its own, for that group; it has not begun yet. */
  GroupAgent group(Group group) {
    return group(group, knowledge);
  }

  /**
   * @param knowledge that of the society, as that agent sees it
   */
  GroupAgent group(Group group, KnowledgeBase knowledge) {
    ReasoningServices mind =
        new ReasoningServices(knowledge, new OptimalPlanner(), Duration.ofMillis(20));
    return new GroupAgent(
        birth(),
        time,
        mind,
        group,
        story::add,
        Past.none(),
        new Dialogues(mind.knowledge()::home, mind.knowledge()::snapshot, time.clock()::instant),
        Spokesmen.BY_NAME);
  }

  /** What everybody here knows. */
  KnowledgeBase knowledge() {
    return knowledge;
  }

  /** Somebody has seen that it is so. */
  void seen(String fact) {
    knowledge.state(new Source(Source.Kind.OBSERVED, "usher"), List.of(fact));
  }

  public Actor add(String member, Actor.Part part) {
    return add(container, member, part);
  }

  /** One whom nobody waits for. */
  Actor actor(String name, Actor.Part part) {
    Actor actor = new Actor(birth(), time, part);
    start(container, name, actor);
    return actor;
  }

  public Actor add(AgentContainer where, String member, Actor.Part part) {
    Actor actor = new Actor(birth(), time, part);
    start(where, member, actor);
    clock.runUntil(() -> cca.presentMembers().contains(member), LONGEST);
    return actor;
  }

  void kill(String agent) {
    try {
      if (controllers.containsKey(agent)) {
        controllers.remove(agent).kill();
        Awaitility.await().pollInterval(Duration.ofMillis(2)).until(() -> !isAlive(agent));
      }
    } catch (StaleProxyException e) {
      throw new IllegalStateException(e);
    }
  }

  /** JADE ends an agent beside its caller. */
  private boolean isAlive(String agent) {
    try {
      container.getPlatformController().getAgent(agent);
      return true;
    } catch (ControllerException e) {
      return false;
    }
  }

  /** The agent has ended by other means. */
  void forget(String agent) {
    controllers.remove(agent);
  }

  /** States a goal and runs until it has ended and nobody is busy with it any more. */
  public Outcome pursue(String goal) {
    List<ACLMessage> replies = Collections.synchronizedList(new ArrayList<>());
    Duration begin = clock.now();
    desk.requestGoal(SlParser.formula(goal), replies::add);
    clock.runUntil(
        () -> replies.stream().anyMatch(r -> r.getPerformative() != ACLMessage.AGREE), LONGEST);
    Duration took = clock.now().minus(begin);
    return new Outcome(replies.get(replies.size() - 1), took);
  }

  /** The goal was reached by the butler, and the story tells why not by the usher. */
  void assertDoneBy(Actor butler, Outcome outcome, String told, Duration within) {
    assertThat(outcome.reached()).as(told()).isTrue();
    assertThat(butler.heard()).endsWith("request");
    assertThat(told()).contains(told);
    assertThat(outcome.took()).as(told()).isLessThan(within);
    assertThat(leftover()).isEmpty();
  }

  /** The goal was given up, and the story tells that it was for the usher. */
  void assertGivenUp(Outcome outcome, String told, Duration within) {
    assertThat(outcome.reached()).as(told()).isFalse();
    assertThat(told()).contains(told);
    assertThat(outcome.reply().getContent()).contains("usher");
    assertThat(outcome.took()).as(told()).isLessThan(within);
    assertThat(leftover()).isEmpty();
  }

  public String told() {
    synchronized (story) {
      return String.join("\n", story.stream().map(e -> e.kind() + " " + e.text()).toList());
    }
  }

  /** Lets all that was begun come to its end; says what does not. */
  public String leftover() {
    // What is just being sent is in no queue yet, so that it may be quiet for a moment.
    for (int i = 0; i < MOST_LOOKS && !isQuiet(); i++) {
      clock.runUntil(this::isQuiet, LONGEST);
    }
    return isQuiet()
        ? ""
        : "conversations %d and %d, behaviours %d, orders %d, contracts %s"
            .formatted(
                cca.conversations().openCount(),
                desk.conversations().openCount(),
                cca.behaviourCount() - behavioursOfCca,
                cca.ordersUnderway(),
                cca.contractsOpen());
  }

  private boolean isQuiet() {
    return cca.conversations().openCount() == 0
        && desk.conversations().openCount() == 0
        && cca.behaviourCount() == behavioursOfCca
        && cca.ordersUnderway() == 0
        && !cca.contractsOpen()
        && cca.getCurQueueSize() == 0;
  }

  /** Lets simulated time pass until it is so. */
  public void await(BooleanSupplier condition, Duration limit) {
    assertThat(clock.runUntil(condition, limit)).as(told()).isTrue();
  }

  /** Lets simulated time pass. */
  public void pass(Duration duration) {
    boolean[] passed = {false};
    clock.schedule(duration, "test", () -> passed[0] = true);
    clock.runUntil(() -> passed[0], duration.plusSeconds(1));
  }

  @Override
  public void close() {
    List.copyOf(controllers.keySet()).forEach(this::kill);
  }
}
