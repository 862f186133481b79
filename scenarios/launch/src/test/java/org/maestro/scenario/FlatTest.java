package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.junit.MaestroAssertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;
import org.maestro.platform.AgentRow;
import org.maestro.sim.world.World;

/**
 * One plan over nearly every kind of hardware (Three-layered architecture, abstract; M2): shutter,
 * switch, door, light sensors, cameras, and a robot with Mecanum wheels and a jamming gripper
 * (Three-layered architecture, 4.1; M80).
 */
@MaestroTest(home = "flat", scene = "flat-day")
class FlatTest {

  @Test
  void shutterSwitchDoorAndRobotBringTheBook(Stage stage) {
    World world = stage.world();
    assertThat(world.lux("living")).isLessThan(72);
    assertThat(world.lux("sleeping")).isLessThan(72);
    assertThat(world.isOpen("bedroom-door")).isFalse();

    assertThat(stage.goal("(nextTo Book Ada)"))
        .isReached()
        .tells("lux-bedroom reports")
        .tells("looks for Book")
        .tells("rose picks up Book")
        .tells("shutter is set to an opening of")
        .tells("bed-lamp is set to 1")
        .tells("bedroom-door opens");
    assertThat(world.isNextTo("Book", "Ada")).isTrue();
    assertThat(world.opening("shutter")).isPositive();
    assertThat(world.lampLevel("bed-lamp")).isEqualTo(1);
    assertThat(world.isOpen("bedroom-door")).isTrue();
  }

  /**
   * Hardware and its domain part make one agent; none stands for two, none is without
   * (Three-layered architecture, 3; M24).
   */
  @Test
  void eachDeviceIsAnAgentOfItsOwn(Stage stage) {
    assertThat(stage.platform().agents().stream().filter(row -> !row.members().isEmpty()).toList())
        .allSatisfy(row -> assertThat(row.members()).containsExactly(row.agent()))
        .extracting(AgentRow::agent)
        .containsExactlyInAnyOrderElementsOf(stage.knowledge().home().devices().keySet());
  }

  /** As {@code ./maestro stop} asks for it (Three-layered architecture, 3.2.1; M37). */
  @Test
  void whenAllIsToStopEachDeviceIsSafeWithinASecond(Stage stage) {
    stage
        .platform()
        .desk()
        .request(
            ACLMessage.REQUEST,
            AgentNames.SUPERVISOR,
            Duration.ofSeconds(30),
            reply -> {},
            Words.content("perform", Words.named("action", Words.name("stop"))));
    stage.run(Duration.ofSeconds(1));

    assertThat(stage.platform().agents().stream().filter(row -> !row.members().isEmpty()))
        .hasSameSizeAs(stage.knowledge().home().devices().keySet())
        .extracting(AgentRow::state)
        .containsOnly("safe");
  }

  @Test
  void aRobotChargesItsBattery(Stage stage) {
    stage.world().charge("rose", 0.9);
    stage.run(Duration.ofSeconds(6));
    assertThat(stage.goal("(>= (charge rose) 1)"))
        .isReached()
        .tells("rose charges its battery at dock");
    assertThat(stage.world().charge("rose")).isGreaterThan(0.99);
  }
}
