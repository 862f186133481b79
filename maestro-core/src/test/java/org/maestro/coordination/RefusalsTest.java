package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.Term;

/** What is refused is not asked for again on unchanged facts, and what refusals say is learnt. */
class RefusalsTest {
  private static final double INSISTED_LUX = 100;
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = RefusalsTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  private final PretendHouse house = new PretendHouse(home);

  /** It has described that 72 lux do. */
  @Test
  void aCameraThatInsistsOnMoreLightThanItDescribedGetsIt() {
    double[] wobble = {1};
    house.noise = () -> wobble[0] = 2 - wobble[0] + 0.01;
    cameraInsistsOn(">= 100");

    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.lux("zone-b")).isGreaterThanOrEqualTo(INSISTED_LUX);
    assertThat(refusedLooks("cam-b")).isEqualTo(1);
    assertThat(house.story)
        .anyMatch(
            told ->
                told.contains(
                    "cam-b insists on more than it has described, which counts from now on:"
                        + " the illuminance of zone-b >= 100 lux."));
  }

  @Test
  void whatNobodyCanReachIsNotTriedAgainAndNotCalledImpossible() {
    cameraInsistsOn(">= 5000");
    house.ambientLux.put("zone-b", 80.0);

    GoalOutcome outcome = house.achieve("(exists (?z - Zone) (in Cup ?z))");

    assertThat(outcome.reached()).isFalse();
    assertThat(refusedLooks("cam-b")).as(String.join("\n", house.story)).isEqualTo(1);
    assertThat(outcome.reasons()).anyMatch(reason -> reason.contains("not proven"));
  }

  /** To be silent for no time is no reason to leave somebody alone for a time. */
  @Test
  void aGoalEndsThoughItIsKnownAtOnceThatNobodyNamesAPrice() {
    house.priceless.add("rose");

    GoalOutcome outcome = house.achieve("(in rose zone-a)");

    assertThat(outcome.reached()).isFalse();
    assertThat(outcome.reasons()).anyMatch(reason -> reason.contains("is not there"));
  }

  @Test
  void whatIsInsistedOnCountsForTheNextGoalUntilTheDeviceDescribesItselfAnew() {
    cameraInsistsOn(">= 5000");
    house.ambientLux.put("zone-b", 80.0);
    house.achieve("(exists (?z - Zone) (in Cup ?z))");
    house.achieve("(exists (?z - Zone) (in Cup ?z))");
    assertThat(refusedLooks("cam-b")).isEqualTo(1);

    house.coordinator.memberPresent("cam-b");
    house.achieve("(exists (?z - Zone) (in Cup ?z))");

    assertThat(refusedLooks("cam-b")).isEqualTo(2);
  }

  /** It is on the bus again, and what it sends there cannot be read. */
  @Test
  void whoIsBackAndDescribedWronglyIsNotCalledLost() {
    house.coordinator.memberLost("rose", "rose is lost");
    assertThat(whyNot("(in rose zone-a)")).contains("lost since");

    house.coordinator.memberLost("rose", "its description is refused: (inn rose)");

    assertThat(whyNot("(in rose zone-a)"))
        .contains("rose is needed and not there (its description is refused: (inn rose))")
        .doesNotContain("lost since");
  }

  private String whyNot(String goal) {
    return String.join("\n", house.achieve(goal).reasons());
  }

  /** It says no more than that, and the light changes by less than sensors err. */
  @Test
  void aRefusalWithoutFactsIsNotRepeatedUntilOneOfThemHasChanged() {
    refuse("observeObject", ActionDispatcher.Refusal.AS_THINGS_ARE, List.of());
    house.ambientLux.put("zone-b", 80.0);

    GoalOutcome outcome = house.achieve("(in Cup zone-b)");

    assertThat(outcome.reached()).isFalse();
    assertThat(looks("cam-b")).as(String.join("\n", house.story)).isEqualTo(1);
    assertThat(outcome.reasons())
        .anyMatch(
            reason ->
                reason.contains("it was refused, and nothing that it rests on has changed: No"));
  }

  /** Such as for somebody who stands in the way. */
  @Test
  void whatIsRefusedForNowIsTriedOnceMoreAfterAWhile() {
    refuse("observeObject", ActionDispatcher.Refusal.FOR_NOW, List.of());
    house.ambientLux.put("zone-b", 80.0);

    house.achieve("(in Cup zone-b)");

    assertThat(looks("cam-b")).as(String.join("\n", house.story)).isEqualTo(2);
  }

  @Test
  void noMoreThanWasDescribedIsNoNews() {
    cameraInsistsOn(">= 72");
    house.knowledge.state(
        new Source(Source.Kind.OBSERVED, "lux-b"), List.of("(= (illuminance zone-b) 90)"));

    house.achieve("(nextTo Cup Bob)");

    assertThat(house.story).noneMatch(told -> told.contains("insists"));
  }

  private void cameraInsistsOn(String need) {
    double least = Double.parseDouble(need.substring(3));
    house.reporting =
        (step, report) -> {
          if (!step.feature().procedure().equals("observeObject")
              || !step.member().equals("cam-b")) {
            return report;
          }
          double lux = house.lux("zone-b");
          return lux >= least
              ? report
              : refused(
                  ActionDispatcher.Refusal.FOR_NOW,
                  List.of(
                      new FeatureRun.Learnt(
                          "(illuminance zone-b)", new Term.Number(lux), Optional.of(need))));
        };
  }

  /** Its sentence stands inside of others, which have one full stop and say whose words it is. */
  @Test
  void whatARefusalSaysIsQuotedInOneSentence() {
    refuse("observeObject", ActionDispatcher.Refusal.AS_THINGS_ARE, List.of());
    house.ambientLux.put("zone-b", 80.0);

    house.achieve("(in Cup zone-b)");

    assertThat(house.story)
        .anyMatch(told -> told.contains("That failed: cam-b says: No."))
        .anyMatch(told -> told.contains("Plan again, because cam-b says: No; step "))
        .noneMatch(told -> told.contains("No.;") || told.contains("No..") || told.contains("No.)"));
  }

  @Test
  void aReasonInWordsThatNobodyHasIsPassedOverAndToldSo() {
    refuse(
        "observeObject",
        ActionDispatcher.Refusal.AS_THINGS_ARE,
        List.of(new FeatureRun.Learnt("(duck away)", new Term.Truth(true))));
    house.ambientLux.put("zone-b", 80.0);

    house.achieve("(in Cup zone-b)");

    assertThat(house.story)
        .anyMatch(
            told ->
                told.contains(
                    "That failed: cam-b says: No (its reason (duck away) is passed over: it uses"
                        + " the unknown predicate duck"))
        .noneMatch(told -> told.contains("so away is"));
  }

  private void refuse(
      String feature, ActionDispatcher.Refusal refusal, List<FeatureRun.Learnt> refs) {
    house.reporting =
        (step, report) ->
            step.feature().procedure().equals(feature) ? refused(refusal, refs) : report;
  }

  private ActionDispatcher.Report refused(
      ActionDispatcher.Refusal refusal, List<FeatureRun.Learnt> refs) {
    refusals++;
    return new ActionDispatcher.Report(
        false, Map.of(), Optional.of("No."), refs, true, Optional.of(refusal), false);
  }

  private int refusals;

  private int refusedLooks(String camera) {
    assertThat(looks(camera)).isPositive();
    return refusals;
  }

  private long looks(String camera) {
    return house.calls.stream().filter(("observeObject " + camera)::equals).count();
  }
}
