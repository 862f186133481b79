package org.maestro.daylight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;
import org.maestro.sim.world.World;

/** The same with all agents: light on a desk while the sun comes out and clouds return. */
@MaestroTest(home = "study", scene = "study-noon")
class DaylightStageTest {
  private static final Position DESK = new Position(2.1, 3, 0.75);

  @Test
  void lampsAreReleasedWhileTheSunShines(Stage stage) {
    World world = stage.world();
    assertThat(world.lux(DESK)).isLessThan(300);
    Pursuit light = stage.begin("(keep (>= (illuminance desk) 300))");
    stage.await("the desk is lit", () -> world.lux(DESK) >= 300);
    assertThat(levels(world)).isPositive();

    world.setClouds(0);
    stage.await("the lamps are released", () -> levels(world) == 0);
    assertThat(world.lux(DESK)).isGreaterThan(300);

    world.setClouds(1);
    assertThat(world.lux(DESK)).isLessThan(300);
    light.awaitTelling("It is so again");
    assertThat(world.lux(DESK)).isGreaterThan(300);
  }

  private static double levels(World world) {
    return Stream.of("lamp-1", "lamp-2", "lamp-3", "lamp-4").mapToDouble(world::lampLevel).sum();
  }
}
