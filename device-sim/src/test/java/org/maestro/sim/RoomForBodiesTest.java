package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Completion;
import org.maestro.hal.GripperArm;
import org.maestro.hal.MobileBase;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.sim.scene.Stop;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.Walks;
import org.maestro.sim.world.World;

/** Two bodies are never at one place. */
class RoomForBodiesTest {

  private static Completion into(List<String> ends) {
    return new Completion() {
      @Override
      public void done() {
        ends.add("done");
      }

      @Override
      public void failed(String reason) {
        ends.add(reason);
      }
    };
  }

  @Test
  void nothingIsPutWhereSomethingStands() {
    try (Homes homes = Homes.bob("bob-lit")) {
      homes.call("rose", "pick", Map.of("object", homes.at("Cup")));
      GripperArm arm = homes.simulated.drivers("rose").find(GripperArm.class).orElseThrow();
      Position rose = homes.world().position("rose").orElseThrow();
      Position spot = new Position(rose.x(), rose.y() - 0.5, 0);
      List<String> ends = new ArrayList<>();
      arm.extend(spot, into(ends));
      homes.clock.run(Duration.ofSeconds(2));
      assertThat(arm.isPlaceFree()).isTrue();
      homes.world().moveByHand("Bob", spot);
      assertThat(arm.isPlaceFree()).isFalse();
      arm.release(into(ends));
      homes.clock.run(Duration.ofSeconds(2));
      assertThat(ends).containsExactly("done", "something stands there already");
      assertThat(homes.world().held("rose")).contains("Cup");
    }
  }

  @Test
  void robotsThatMeetStopBeforeTheyTouch() {
    try (Homes homes = new Homes("bob-two-robots", "bob-two-robots", 1, scene -> scene)) {
      World world = homes.world();
      List<String> ends = new ArrayList<>();
      Point2 rose = world.position("rose").orElseThrow().floor();
      Point2 tim = world.position("tim").orElseThrow().floor();
      drive(homes, "rose", tim, ends);
      drive(homes, "tim", rose, ends);
      double apart = world.radius("rose") + world.radius("tim");
      for (int i = 0; i < 60; i++) {
        homes.clock.run(Duration.ofMillis(50));
        assertThat(world.distance("rose", "tim")).isGreaterThan(apart - 0.02);
      }
      assertThat(ends).contains("something stands in the way");
    }
  }

  /** Somebody who walks beside a robot and turns to it within its scanner's time runs into it. */
  @Test
  void whoRunsIntoADrivingRobotIsTold() {
    try (Homes homes =
        new Homes(
            "bob",
            "bob-lit",
            1,
            scene ->
                scene
                    .with("rose", scene.of("rose").at(new Position(3.6, 0.8, 0)))
                    .with("Bob", scene.of("Bob").at(new Position(3.6, 1.5, 0)))
                    .with("Cup", scene.of("Cup").at(new Position(5.6, 2.6, 0))))) {
      List<WorldEvent> collisions = new ArrayList<>();
      homes
          .world()
          .listen(
              event -> {
                if (event.kind() == WorldEvent.Kind.COLLIDED) {
                  collisions.add(event);
                }
              });
      new Walks(homes.world(), homes.clock)
          .start(
              "Bob",
              List.of(new Stop(new Point2(4.64, 1.5), 0), new Stop(new Point2(4.64, 0.8), 0)));
      List<String> ends = new ArrayList<>();
      drive(homes, "rose", new Point2(5.4, 0.8), ends);
      homes.clock.run(Duration.ofMillis(1300));
      assertThat(collisions).isEmpty();
      homes.clock.run(Duration.ofMillis(400));
      assertThat(collisions).extracting(WorldEvent::subject).containsOnly("rose");
      assertThat(collisions).extracting(event -> event.thing().orElse("")).containsOnly("Bob");
    }
  }

  private static void drive(Homes homes, String robot, Point2 to, List<String> ends) {
    homes
        .simulated
        .drivers(robot)
        .find(MobileBase.class)
        .orElseThrow()
        .drive(List.of(to), into(ends));
  }
}
