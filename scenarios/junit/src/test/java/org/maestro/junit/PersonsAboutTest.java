package org.maestro.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

/** Persons who walk about in a test, and rooms in which one hears what is said (ADE, 5; A84). */
@MaestroTest(home = "evening", scene = "evening")
class PersonsAboutTest {

  @Test
  void whoWalksComesThroughTheDoorsAndIsToldWhereSheIs(Stage stage) {
    Room kitchen = stage.room("kitchen");
    Room bedroom = stage.room("bedroom");
    Duration begun = stage.clock().now();

    stage.persons().walk("Mia", "kitchen");

    assertThat(kitchen.holds("Mia")).isTrue();
    assertThat(stage.clock().now().minus(begun))
        .as("she walks")
        .isGreaterThan(Duration.ofSeconds(3));
    stage.speaker("Dave").in("livingroom").says("let the kids know it's time for bed").isReached();
    kitchen.awaits("it's time for bed");
    bedroom.hasHeardNothing();
    assertThat(stage.knowledge()).knows("(presence motion-kitchen)");
  }

  @Test
  void whereNoWayIsOpenNobodyWalks(Stage stage) {
    stage.world().setDoor("garden-door", false);

    assertThatThrownBy(() -> stage.persons().walk("Mia", "garden"))
        .isInstanceOf(StageException.class)
        .hasMessage("There is no way for Mia to garden that is open.");
  }
}
