package org.maestro.agents;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.maestro.agents.content.AgentNames;
import org.maestro.knowledge.api.ForwardingKnowledge;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.home.RoomHearing;
import org.maestro.ontology.home.StatedWorth;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/** What an agent that stands for a group does when another agent takes the place of a member's. */
class GroupAgentTest {
  private static final String HERE = "first@here";
  private static final String THERE = "first@there";

  /** Simulated time; less than the pause between two roll calls. */
  private static final Duration SOON = Duration.ofSeconds(15);

  @RegisterExtension static final SocietyExtension STAGE = new SocietyExtension("groups");

  private final List<String> done = Collections.synchronizedList(new ArrayList<>());
  private final List<String> refused = Collections.synchronizedList(new ArrayList<>());
  private Society society;
  private GroupAgent keeper;

  @BeforeEach
  void gather() {
    society = STAGE.society();
    keeper = society.group(usherThat(List.of(SlParser.formula("(keep (greeted Bob))"))));
  }

  private static Group usherThat(List<Formula> pursues) {
    Individual itself = new Individual("keeper", "urn:keeper", "the keeper", Set.of(), Map.of());
    return new Group(itself, Optional.empty(), Set.of("usher"), Optional.empty(), pursues);
  }

  @Test
  void anAgentThatIsCalledInAnotherWayIsOrderedInThatWayAtOnce() {
    society.add("usher", living(HERE, Duration.ofSeconds(1)));
    society.start("keeper", keeper);
    society.await(() -> done.contains(HERE), SOON);

    anotherUsher(THERE, () -> keeper.agentMoves("usher"));
    society.pass(Duration.ofSeconds(2));
    society.seen("(not (greeted Bob))");
    society.await(() -> done.contains(THERE), SOON);

    assertThat(refused).isEmpty();
  }

  @Test
  void whatTheAgentBeforeWasAtIsOrderedInTheSameWords() {
    society.add("usher", living(HERE, Duration.ofMinutes(10)));
    society.start("keeper", keeper);
    society.pass(Duration.ofSeconds(5));

    anotherUsher(HERE, () -> keeper.agentMoves("usher"));
    society.await(() -> society.told().contains("It is so"), SOON);

    assertThat(society.told()).doesNotContain("Plan 2");
  }

  @Test
  void anAgentThatEndedIsNotCountedOnUntilThereIsAnother() {
    society.add("usher", living(HERE, Duration.ofSeconds(1)));
    society.start("keeper", keeper);
    society.await(() -> done.contains(HERE), SOON);

    society.kill("usher");
    keeper.agentEnded("usher");
    society.seen("(not (greeted Bob))");
    society.pass(Duration.ofSeconds(5));
    assertThat(society.told()).contains("its agent has ended");
    society.start(
        "usher", new Actor(society.birth(), society.time, living(THERE, Duration.ofSeconds(1))));
    keeper.agentBegins("usher");
    society.await(() -> done.contains(THERE), SOON);

    assertThat(refused).isEmpty();
  }

  /** Of a thousand agents without a goal, none looks at what the other thousand say. */
  @Test
  void withoutAGoalItDoesNotWakeForWhatOthersTell() {
    AtomicInteger looks = new AtomicInteger();
    KnowledgeBase seen =
        new ForwardingKnowledge(society.knowledge()) {
          @Override
          public Home home() {
            looks.incrementAndGet();
            return super.home();
          }
        };
    society.add("usher", living(HERE, Duration.ofSeconds(1)));
    society.start("keeper", society.group(usherThat(List.of()), seen));
    society.pass(Duration.ofSeconds(15));
    int before = looks.get();

    for (int i = 0; i < 20; i++) {
      describes("butler", i);
    }
    society.pass(Duration.ofSeconds(1));
    assertThat(looks).hasValue(before);

    describes("usher", 0);
    society.await(() -> looks.get() > before, SOON);
  }

  /** What it was asked before its end nobody else would ever hear of (A91). */
  @Test
  void whatTheCentralAgentHasHeardAndNotAnsweredTheRoomDoesWhenThatEnds() {
    Group hall =
        new Group(
            new Individual("hall-agent", "urn:hall-agent", "hall", Set.of(), Map.of()),
            Optional.empty(),
            Set.of(),
            Optional.empty(),
            List.of(),
            StatedWorth.NONE,
            true,
            Optional.of(new RoomHearing(Set.of("hall"), Set.of(), Optional.empty())));
    GroupAgent room = society.group(hall);
    society.start("hall-agent", room);
    society.kill(AgentNames.COORDINATOR);
    Actor silent = society.actor(AgentNames.COORDINATOR, Actor.Part.onOrder((actor, order) -> {}));
    Actor bystander = society.actor("usher", new Actor.Part() {});

    bystander.ask("hall-agent", ACLMessage.ACCEPT_PROPOSAL, "(say \"hello\" (:by Bob) (:in hall))");
    society.await(() -> silent.heard().contains("request"), SOON);
    assertThat(bystander.heard()).isEmpty();

    society.kill(AgentNames.COORDINATOR);
    room.agentDied(AgentNames.COORDINATOR);
    society.await(() -> bystander.heard().contains("inform"), SOON);
    assertThat(room.conversations().openCount()).isZero();
  }

  private void describes(String device, int time) {
    society
        .knowledge()
        .state(
            new Source(Source.Kind.DESCRIBED, device),
            List.of(time % 2 == 0 ? "(greeted Bob)" : "(not (greeted Bob))"));
  }

  /** As the platform tells of it. */
  private void anotherUsher(String life, Runnable told) {
    told.run();
    society.kill("usher");
    society.start(
        "usher", new Actor(society.birth(), society.time, living(life, Duration.ofSeconds(1))));
    keeper.agentBegins("usher");
  }

  private Actor.Part living(String life, Duration work) {
    return new Actor.Part() {
      @Override
      public void subscribed(Actor actor, ACLMessage subscription) {
        actor.answer(
            subscription,
            ACLMessage.INFORM,
            "(inform (:member usher) (:phase ready) (:life \"%s\"))".formatted(life));
      }

      @Override
      public void ordered(Actor actor, ACLMessage order) {
        String words = order.getContent();
        if (!words.contains(":life") || words.contains("(:life \"%s\")".formatted(life))) {
          actor.answer(order, ACLMessage.AGREE, "(perform)");
          actor.later(
              work,
              () -> {
                actor.done(order);
                if (words.contains(":life")) {
                  done.add(life);
                }
              });
        } else {
          refused.add(words);
          actor.answer(order, ACLMessage.REFUSE, "(inform (:reason \"started again\"))");
        }
      }
    };
  }
}
