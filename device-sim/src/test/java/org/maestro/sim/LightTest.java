package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.floor.Segment;
import org.maestro.sim.world.LampLight;
import org.maestro.sim.world.World;

class LightTest {

  private static final Polygon WEST = Polygon.parse("0 0, 4 0, 4 4, 0 4");
  private static final Polygon EAST = Polygon.parse("4 0, 8 0, 8 4, 4 4");
  private static final Segment DOOR = new Segment(new Point2(4, 1.5), new Point2(4, 2.5));
  private static final FloorPlan OPEN = new FloorPlan(List.of(WEST, EAST), List.of(DOOR));
  private static final FloorPlan CLOSED = new FloorPlan(List.of(WEST, EAST), List.of());

  private static LampLight lamp(double x, double beam) {
    return new LampLight(Pose.parse(x + " 2 2"), 400, beam, 1, 1);
  }

  private static Position floor(double x, double y) {
    return new Position(x, y, 0);
  }

  @Test
  void fallsWithTheSquareOfTheHeightBelowTheLamp() {
    assertThat(lamp(2, 120).lux(floor(2, 2), OPEN)).isCloseTo(100, within(1e-9));
    assertThat(lamp(2, 120).lux(new Position(2, 2, 1), OPEN)).isCloseTo(400, within(1e-9));
  }

  @Test
  void fallsWithTheCubeOfTheCosineAside() {
    // 2 m aside at 2 m height: cos 45 degrees to the third, 0.35355
    assertThat(lamp(2, 120).lux(floor(4 - 1e-3 - 0, 2), OPEN))
        .isCloseTo(100 * Math.pow(Math.cos(Math.atan(0.9995)), 3), within(1e-9));
    assertThat(lamp(1, 120).lux(floor(3, 2), OPEN)).isCloseTo(35.355, within(0.001));
  }

  @Test
  void endsAtTheBeamsEdge() {
    // a beam of 90 degrees is 2 m wide on each side at 2 m height
    assertThat(lamp(1, 90).lux(floor(2.999, 2), OPEN)).isPositive();
    assertThat(lamp(1, 90).lux(floor(3.001, 2), OPEN)).isZero();
  }

  @Test
  void doesNotPassWallsAndClosedDoors() {
    LampLight lamp = lamp(3, 150);
    assertThat(lamp.lux(floor(5, 2), OPEN)).isCloseTo(35.355, within(0.001));
    assertThat(lamp.lux(floor(5, 2), CLOSED)).isZero();
    assertThat(lamp.lux(floor(5, 3.5), OPEN)).isZero();
  }

  @Test
  void growsWithLevelAndStrength() {
    LampLight lamp = lamp(2, 120);
    assertThat(lamp.at(0.5).lux(floor(2, 2), OPEN)).isCloseTo(50, within(1e-9));
    assertThat(lamp.weakened(0.7).lux(floor(2, 2), OPEN)).isCloseTo(70, within(1e-9));
    assertThat(lamp.at(0).lux(floor(2, 2), OPEN)).isZero();
  }

  @Test
  void addsUpOverLampsAndTheRestLight() {
    try (Homes homes = Homes.bob("bob-dark")) {
      World world = homes.world();
      Position point = floor(4.5, 1.5);
      assertThat(world.lux(point)).isCloseTo(17, within(1e-9));
      world.lighting().setLevel("lamp-b1", 1);
      // lamp-b1 is 0.4 m aside at 2.8 m: 505 * 2.8 / 8^1.5 with 0.16 + 7.84 = 8
      double first = 505 * 2.8 / Math.pow(8, 1.5);
      assertThat(world.lux(point)).isCloseTo(17 + first, within(1e-9));
      world.lighting().setLevel("lamp-b2", 1);
      assertThat(world.lux(point))
          .isCloseTo(17 + first + 443.5 * 2.8 / Math.pow(8, 1.5), within(1e-9));
      world.die("lamp-b1");
      assertThat(world.lux(point)).isCloseTo(17 + 443.5 * 2.8 / Math.pow(8, 1.5), within(1e-9));
    }
  }

  @Test
  void shinesThroughTheDoorOnlyWhileItIsOpen() {
    try (Homes homes = Homes.bob("bob-dark")) {
      Position behindTheDoor = floor(3.5, 2.4);
      assertThat(homes.world().lux(behindTheDoor)).isGreaterThan(40);
      homes.world().setDoor("door-ab", false);
      assertThat(homes.world().lux(behindTheDoor)).isCloseTo(17, within(1e-9));
    }
  }
}
