package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.Term;

/**
 * Nobody reaches for what his gripper cannot hold, and nothing is impossible by what is unknown.
 */
class SizesTest {
  private static final String CUP = ":size \"0.08 0.08 0.1\"";
  private static final String MUG = ":size \"0.13 0.12 0.1\"";

  /** Fixed in zone-b, where it reaches 0.8 m. */
  private static final String ARM =
      "home:arm a maestro:Device , maestro:Place ; maestro:pose \"4 1 0.5\" ; :reach 0.8 ;"
          + " :payload 2 ; maestro:offers :pick , :place";

  @Test
  void whatNoGripperTakesIsImpossibleBeforeAnythingMoves() {
    PretendHouse house = house(MUG, "; :gripperOpening 0.08", "");

    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(house.calls).noneMatch(call -> call.endsWith(" rose"));
    assertThat(outcome.reasons())
        .containsExactly(
            "The width of Cup has to be at most the gripper opening of rose (0.08 m), so that rose"
                + " picks up Cup, and it is 0.12 m. It would do if the gripper opening of rose were"
                + " at least 0.12 m.");
  }

  @Test
  void ofTwoGrippersTheOneThatFitsIsUsedAlsoWhereItIsDearer() {
    PretendHouse usual = house(CUP, "; :gripperOpening 0.08", "; :gripperOpening 0.2");
    usual.achieve("(nextTo Cup Bob)");
    assertThat(usual.calls).contains("pick rose").doesNotContain("pick tim");

    PretendHouse house = house(MUG, "; :gripperOpening 0.08", "; :gripperOpening 0.2");
    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).contains("pick tim").doesNotContain("pick rose");
  }

  @Test
  void whatNobodyKnowsMakesNothingImpossible() {
    for (String size : List.of(MUG, "")) {
      for (String opening : List.of("", "; :gripperOpening 0.08")) {
        if (size.isEmpty() || opening.isEmpty()) {
          PretendHouse house = house(size, opening, "");
          assertThat(house.achieve("(nextTo Cup Bob)").reached())
              .as(size + opening + String.join("\n", house.story))
              .isTrue();
        }
      }
    }
  }

  /** Neither has said how wide it opens; the first, who is there already, finds out. */
  @Test
  void whatAGripperRefusesForItsWidthIsLearntOfThatOne() {
    PretendHouse house = house(MUG, "", "; :speed 0.8");
    refuseWidth(house, "rose");

    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).filteredOn("pick rose"::equals).hasSize(1);
    assertThat(house.calls).contains("pick tim");
    assertThat(house.story)
        .anyMatch(told -> told.contains("rose insists on more than it has described"));
  }

  /** It has learnt nothing of things whose width nobody knows. */
  @Test
  void whoHasRefusedAThingForItsWidthIsStillAskedForOthers() {
    PretendHouse house = house("", "", "");
    refuseWidth(house, "rose");
    house.achieve("(nextTo Cup Bob)");
    assertThat(house.calls).filteredOn("pick rose"::equals).hasSize(1);

    house.reporting = (step, report) -> report;
    house.place.put("Plate", "zone-b");
    GoalOutcome outcome = house.achieve("(nextTo Plate Bob)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
  }

  @Test
  void whatLiesHigherThanAnArmReachesIsImpossibleBeforeAnythingMoves() {
    PretendHouse house = house(CUP, "; :reachHeight 1.2", "");
    cupIsAt(house, "4.5 1.5 1.8");

    GoalOutcome outcome = house.achieve("(in Cup zone-a)");

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(house.calls).as(String.join("\n", house.story)).isEmpty();
    assertThat(String.join(" ", outcome.reasons())).contains("Cup is not out of reach of rose");
  }

  @Test
  void whatLiesLowEnoughOrWhoeverHasSaidNothingOfHeightsIsUsed() {
    PretendHouse low = house(CUP, "; :reachHeight 1.2", "");
    cupIsAt(low, "4.5 1.5 1.1");
    assertThat(low.achieve("(in Cup zone-a)").reached()).isTrue();

    PretendHouse unsaid = house(CUP, "; :reach 0.1", "");
    cupIsAt(unsaid, "4.5 1.5 1.8");
    assertThat(unsaid.achieve("(in Cup zone-a)").reached()).isTrue();
  }

  /** What it cannot reach up to another brings down. */
  @Test
  void whatLiesTooHighForOneTheOtherBrings() {
    PretendHouse house = house(CUP, "; :reachHeight 1.2", "; :reachHeight 2");
    cupIsAt(house, "4.5 1.5 1.8");

    GoalOutcome outcome = house.achieve("(in Cup rose)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls)
        .containsSubsequence("pick tim", "place tim", "pick rose")
        .containsOnlyOnce("pick rose");
  }

  @Test
  void anArmThatDoesNotMoveTakesWhatLiesWithinItsReach() {
    PretendHouse near = house(CUP, "", ARM);
    cupIsAt(near, "4.5 1.4 0");
    assertThat(near.achieve("(in Cup arm)").reached()).isTrue();
    assertThat(near.calls).containsExactly("pick arm");

    PretendHouse far = house(CUP, "; :gripperOpening 0.01", ARM);
    cupIsAt(far, "5.5 2.5 0");
    GoalOutcome outcome = far.achieve("(in Cup arm)");
    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(far.calls).as(String.join("\n", far.story)).isEmpty();
  }

  private static void cupIsAt(PretendHouse house, String place) {
    house.knowledge.state(
        new Source(Source.Kind.OBSERVED, "cam-b"),
        List.of("(position Cup \"%s\")".formatted(place)));
  }

  private static void refuseWidth(PretendHouse house, String member) {
    house.reporting =
        (step, report) -> {
          if (!step.feature().procedure().equals("pick") || !step.member().equals(member)) {
            return report;
          }
          house.place.put("Cup", "zone-b");
          return new ActionDispatcher.Report(
              false,
              Map.of(),
              Optional.of("Too wide."),
              List.of(
                  new FeatureRun.Learnt(
                      "(width Cup)", new Term.Number(0.12), Optional.of("<= 0.08"))),
              true,
              Optional.of(ActionDispatcher.Refusal.FOR_NOW),
              false);
        };
  }

  /** Bob's home with a robot more, far away and slow, where anything is said of it. */
  private static PretendHouse house(String size, String rose, String tim) {
    try (InputStream turtle = SizesTest.class.getResourceAsStream("/bob.ttl")) {
      String text = new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
      String said =
          text.replace(CUP + " ;", size.isEmpty() ? "" : size + " ;")
              .replace(":payload 0.5 .", ":payload 0.5 " + rose + " .");
      assertThat(said).contains("home:Cup").doesNotContain(size.equals(CUP) ? "none" : CUP);
      String more =
          "\nhome:Plate a :Item ; :colour \"white\" ; :mass 0.2 ; :usuallyIn home:zone-b .\n"
              + (tim.isEmpty() || tim.equals(ARM)
                  ? (tim.isEmpty() ? "" : tim + " .\n")
                  : "home:tim a :MobileRobot ; :colour \"pink\" ; :size \"0.5 0.4 0.4\" ; :payload"
                      + " 1"
                      + (tim.contains(":speed") ? "" : " ; :speed 0.1")
                      + tim
                      + " .\n");
      Home home = new HomeLoader().load(said + more, "bob.ttl");
      return new PretendHouse(home);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
