package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** The way of a goal through Bob's home, without agents and devices. */
class CoordinatorTest {
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = CoordinatorTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  private final PretendHouse house = new PretendHouse(home);

  @Test
  void theCupComesToBobThoughItsRoomIsDark() {
    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(outcome.confirmed()).isTrue();
    assertThat(house.place).containsEntry("Cup", "zone-a");
    assertThat(outcome.calls()).isLessThanOrEqualTo(14);
    assertThat(house.calls).filteredOn(c -> c.startsWith("adjustLight")).hasSize(2);
  }

  @Test
  void litRoomsNeedNoLamp() {
    house.ambientLux.put("zone-b", 100.0);

    assertThat(house.achieve("(nextTo Cup Bob)").reached()).isTrue();
    assertThat(house.calls).noneMatch(c -> c.startsWith("adjustLight"));
  }

  @Test
  void whatEarlierStepsMakePossibleIsNotGivenUpBecauseItCannotBeDoneNow() {
    house.ambientLux.put("zone-a", 100.0);
    house.place.put("Cup", "zone-a");
    house.declines = feature -> feature.equals("pick") && !house.place.get("rose").equals("zone-a");

    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
  }

  @Test
  void whatIsReachedButNeverSeenIsNotCalledImpossible() {
    house.ambientLux.put("zone-b", 100.0);

    GoalOutcome outcome = house.achieve("(in Cup rose)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(outcome.confirmed()).isFalse();
    assertThat(house.calls).noneMatch(call -> call.startsWith("place"));
  }

  /** The camera that could see it dies; the other one is elsewhere. */
  @Test
  void nothingIsCarriedAboutOnlyToBeSeen() {
    house.ambientLux.put("zone-a", 100.0);
    house.ambientLux.put("zone-b", 100.0);
    house.beforeCall =
        call -> {
          if (call.equals("place rose")) {
            house.coordinator.memberLost("cam-a", "no power");
          }
        };

    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(outcome.confirmed()).isFalse();
    assertThat(outcome.reasons())
        .containsExactly("It is done, as far as rose says; nobody can confirm it.");
    assertThat(house.calls).filteredOn(call -> call.equals("pick rose")).hasSize(1);
    assertThat(house.place).containsEntry("Cup", "zone-a");
  }

  @Test
  void whatARobotTellsOfItselfAfterItsReportIsStillItsWordAlone() {
    house.ambientLux.put("zone-b", 100.0);
    house.beforeCall =
        call -> {
          if (call.equals("pick rose")) {
            house.clock.schedule(
                Duration.ofMillis(1),
                "rose",
                () ->
                    house.knowledge.state(
                        new Source(Source.Kind.STATED, "rose"),
                        List.of("(in rose zone-b)", "(in Cup rose)")));
          }
        };

    GoalOutcome outcome = house.achieve("(in Cup rose)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(outcome.confirmed()).as(String.join("\n", house.story)).isFalse();
    assertThat(outcome.reasons())
        .containsExactly("It is done, as far as rose says; nobody can confirm it.");
    assertThat(house.calls).noneMatch(call -> call.startsWith("place"));
  }

  @Test
  void whatWasDeclinedForOneGoalIsAskedAgainForTheNext() {
    house.declines = feature -> feature.equals("move");
    assertThat(house.achieve("(in rose zone-a)").reached()).isFalse();

    house.declines = feature -> false;

    GoalOutcome outcome = house.achieve("(in rose zone-a)");
    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
  }

  @Test
  void weakLampsAreHelpedByAnother() {
    house.weak.addAll(List.of("lamp-b1", "lamp-b2", "lamp-b3"));

    assertThat(house.achieve("(nextTo Cup Bob)").reached())
        .as(String.join("\n", house.story))
        .isTrue();
  }

  @Test
  void whoSeesTheCupIsPartOfTheAnswer() {
    GoalOutcome outcome = house.achieve("(canSee ?agent Cup)");

    assertThat(outcome.reached()).isTrue();
    assertThat(outcome.binding()).containsEntry("agent", new Term.Name("cam-b"));
  }

  @Test
  void withoutLampsTheReasonNamesTheLight() {
    for (String lamp : new String[] {"lamp-b1", "lamp-b2", "lamp-b3"}) {
      house.coordinator.memberLost(lamp, "no power");
    }

    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(String.join(" ", outcome.reasons()))
        .contains("illuminance of zone-b")
        .contains("at least 72 lux")
        .contains("it is 17 lux as lux-b measured, and as things are now nobody can make it more")
        .contains("55 lux higher")
        .contains("lamp-b2 were there (lost since");
  }

  @Test
  void whyThisMemberAndNotAnotherCanBeAsked() {
    house.ambientLux.put("zone-b", 40.0);
    house.coordinator.memberLost("lamp-a2", "no power");
    assertThat(house.achieve("(>= (illuminance zone-b) 60)").reached()).isTrue();

    List<String> told = whyStep(OptionalInt.empty(), stepOf("lamp-b"));

    assertThat(told.get(0)).contains("lamp-b").contains("exact prices asked: 0");
    assertThat(told).anyMatch(text -> text.matches("With lamp-b\\d instead the plan would .*"));
    assertThat(told).anyMatch(text -> text.startsWith("lamp-a2 refused: "));
    assertThat(told).noneMatch(text -> text.startsWith("With lux-"));
  }

  @Test
  void whoMeasuresIsNoneWhoseLightCouldBeTakenInstead() {
    house.ambientLux.put("zone-b", 40.0);
    assertThat(house.achieve("(>= (illuminance zone-b) 60)").reached()).isTrue();

    List<String> told = whyStep(OptionalInt.of(1), 1);

    assertThat(told.get(0)).contains("lux-b");
    assertThat(told).noneMatch(text -> text.startsWith("With lamp-"));
  }

  @Test
  void whoSeesAThingIsNoneWhoCouldPickItUpInstead() {
    house.ambientLux.put("zone-b", 100.0);
    assertThat(house.achieve("(nextTo Cup Bob)").reached()).isTrue();

    List<String> told = whyStep(OptionalInt.empty(), stepOf("rose picks up"));

    assertThat(told.get(0)).contains("rose picks up");
    assertThat(told).contains("Nobody else that was asked could take part in it.");
  }

  @Test
  void anEarlierPlanIsExplainedToo() {
    house.weak.addAll(List.of("lamp-b1", "lamp-b2", "lamp-b3"));
    assertThat(house.achieve("(nextTo Cup Bob)").reached()).isTrue();
    assertThat(house.story).anyMatch(text -> text.contains(" Plan 2 "));

    assertThat(whyStep(OptionalInt.of(1), 1).get(0)).startsWith("Step 1: ");
    assertThat(whyStep(OptionalInt.of(99), 1).get(0))
        .contains("these plans are kept: 1, 2")
        .contains("plan 99 is not");
  }

  private List<String> whyStep(OptionalInt plan, int step) {
    List<String> told = new ArrayList<>();
    house.coordinator.explainChoice("G1", plan, step, told::addAll);
    house.clock.run(Duration.ofSeconds(1));
    return told;
  }

  /** The number of a step of the latest plan, by what is told of it. */
  private int stepOf(String words) {
    for (int step = 1; step < 20; step++) {
      if (whyStep(OptionalInt.empty(), step).get(0).contains(words)) {
        return step;
      }
    }
    throw new AssertionError("No step has " + words + " in it: " + String.join("\n", house.story));
  }

  @Test
  void aLampThatDiesIsReplaced() {
    house.beforeCall =
        call -> {
          if (call.equals("adjustLight lamp-b2") && house.dead.add("lamp-b2")) {
            house.coordinator.memberLost("lamp-b2", "no power");
          }
        };

    assertThat(house.achieve("(nextTo Cup Bob)").reached())
        .as(String.join("\n", house.story))
        .isTrue();
    assertThat(house.calls).contains("adjustLight lamp-b3");
  }

  @Test
  void whatNobodyKnowsIsNamedWithWhatIsNear() {
    assertThatThrownBy(
            () ->
                house.coordinator.submit(
                    new GoalRequest(SlParser.formula("(nextTo Cupp Bob)"), "Bob"), o -> {}))
        .isInstanceOf(InvalidGoalException.class)
        .hasMessageContaining("Cupp")
        .hasMessageContaining("Cup");
  }

  @Test
  void aCancelledGoalEnds() {
    List<GoalOutcome> ended = new ArrayList<>();
    String id =
        house.coordinator.submit(
            new GoalRequest(SlParser.formula("(nextTo Cup Bob)"), "Bob"), ended::add);
    house.clock.run(Duration.ofMillis(700));

    assertThat(house.coordinator.cancel(id, "Bob")).isTrue();
    house.clock.run(Duration.ofSeconds(60));

    assertThat(ended).extracting(GoalOutcome::state).containsExactly(GoalState.CANCELLED);
  }
}
