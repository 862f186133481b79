package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.planning.api.Step;

/** Which news are a reason to look at a plan again. */
class ReplanTriggersTest {
  private final KnownHome home = KnownHome.withRoseAtTheCup();
  private final Step pick = home.step("rose", "pick", "object=Cup", "zone=zone-b");
  private final ReplanTriggers triggers =
      new ReplanTriggers(
          home.formula("(canSee cam-a Bob)"), List.of(pick), home.vocabulary, home.now());

  @Test
  void theGoalItself() {
    assertThat(triggers.ofGoal(home.changes("(canSee cam-a Bob)"))).isTrue();
    assertThat(triggers.ofGoal(home.changes("(canSee cam-b Cup)"))).isFalse();
    assertThat(triggers.perhaps(home.changes("(canSee cam-a Bob)"))).isTrue();
    assertThat(triggers.indeed(home.changes("(canSee cam-a Bob)"), home.now())).isTrue();
  }

  @Test
  void whatAStepNeeds() {
    assertThat(triggers.ofGoal(home.changes("(in Cup zone-a)"))).isFalse();
    assertThat(triggers.perhaps(home.changes("(in Cup zone-a)"))).isTrue();
    assertThat(triggers.indeed(home.changes("(in Cup zone-a)"), home.now())).isTrue();
  }

  @Test
  void notWhatConcernsNoPartOfThePlan() {
    assertThat(triggers.perhaps(home.changes("(open door-ab)"))).isFalse();
    assertThat(triggers.indeed(home.changes("(open door-ab)"), home.now())).isFalse();
  }

  @Test
  void whatHoldsOfAnyThingIsLookedAt() {
    FactFilter anotherThing = home.changes("(in Bob zone-a)");

    assertThat(triggers.perhaps(anotherThing)).as("it might be in the hand").isTrue();
    assertThat(triggers.indeed(anotherThing, home.now())).as("it is not").isFalse();

    ProgressedState holding = ProgressedState.of(home.now(), home.vocabulary, pick);
    assertThat(triggers.indeed(anotherThing, holding)).as("the hand is not free").isTrue();
    assertThat(triggers.indeed(anotherThing, holding)).as("that is no news").isFalse();
  }

  @Test
  void whatAPriceOrAnEffectRestsOn() {
    ReplanTriggers ofLamp =
        new ReplanTriggers(
            home.formula("(canSee cam-a Bob)"),
            List.of(home.step("lamp-b1", "adjustLight", "level=1")),
            home.vocabulary,
            home.now());

    assertThat(ofLamp.perhaps(home.changes("(= (level lamp-b1) 0.5)"))).isTrue();
    assertThat(ofLamp.indeed(home.changes("(= (power lamp-b1) 5)"), home.now())).isTrue();
    assertThat(ofLamp.perhaps(home.changes("(= (level lamp-b2) 0.5)"))).isFalse();
  }
}
