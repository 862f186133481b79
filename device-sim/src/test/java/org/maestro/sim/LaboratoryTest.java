package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeMap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Completion;
import org.maestro.hal.DimmableLamp;
import org.maestro.hal.GripperArm;
import org.maestro.hal.Position;
import org.maestro.hal.Target;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.sim.scene.WorldEvent;

/**
 * What the papers' laboratory consists of (Three-layered architecture, 3.1, 3.2, 4.1 and 4.3; M26,
 * M28, M29, M81, M82, M87).
 */
class LaboratoryTest {
  private static final double GRID_METRES = 0.6;

  private final Homes homes = new Homes("arena", "arena-light", 1, scene -> scene);

  @BeforeEach
  void light() {
    for (String zone : List.of("zone-1", "zone-2", "zone-3")) {
      homes.world().setAmbient(zone, 200);
    }
  }

  @AfterEach
  void close() {
    homes.close();
  }

  /** Each figure: how many of the three cameras see a thing that stands there. */
  @Test
  void threeCamerasCoverTheWholeFloor() {
    List<String> map = new ArrayList<>();
    for (double y = 0.3; y < 3; y += GRID_METRES) {
      StringBuilder row = new StringBuilder();
      for (double x = 0.3; x < 8.4; x += GRID_METRES) {
        homes.world().moveByHand("GreenObject", new Position(x, y, 0));
        row.append(List.of("cam-1", "cam-2", "cam-3").stream().filter(this::sees).count());
      }
      map.add(row.toString());
    }
    assertThat(map)
        .as("each zone is one camera's, and at the borders two cameras see the same")
        .allMatch(row -> !row.contains("0") && row.contains("2") && !row.contains("3"))
        .hasSize(5);
  }

  private boolean sees(String camera) {
    Homes.Answer answer =
        homes.call(camera, "observeObject", Map.of("object", Homes.ref("GreenObject")));
    answer.handle().ifPresent(RatsLink.CallHandle::cancel);
    homes.clock.run(Duration.ofMillis(50));
    return Boolean.TRUE.equals(answer.values().get("found"));
  }

  @Test
  void oneCameraLooksAtTwoThings() {
    Map<String, List<Object>> seen = new TreeMap<>();
    List<String> ended = new ArrayList<>();
    homes.world().moveByHand("RedObject1", new Position(7.2, 1.1, 0));
    homes.world().moveByHand("GreenObject", new Position(6.4, 2.0, 0));
    for (String thing : List.of("RedObject1", "GreenObject")) {
      seen.put(thing, new ArrayList<>());
      homes.link.call(
          "cam-3",
          "observeObject",
          Map.of("object", Homes.ref(thing)),
          Duration.ofSeconds(10),
          Optional.empty(),
          new RatsLink.CallListener() {
            @Override
            public void observed(Observation observation) {
              seen.get(thing).add(observation.values().get("found"));
            }

            @Override
            public void ended(Result result) {
              ended.add(thing);
            }
          });
    }
    homes.clock.run(Duration.ofSeconds(5));
    assertThat(seen.get("RedObject1")).isNotEmpty().containsOnly(true);
    assertThat(seen.get("GreenObject")).isNotEmpty().containsOnly(true);

    homes.world().moveByHand("GreenObject", new Position(1.2, 2.0, 0));
    homes.clock.run(Duration.ofSeconds(2));
    assertThat(seen.get("GreenObject")).last().isEqualTo(false);
    assertThat(seen.get("RedObject1")).last().isEqualTo(true);

    homes.call("cam-3", "stopObserve", Map.of("object", Homes.ref("GreenObject")));
    homes.clock.run(Duration.ofSeconds(1));
    assertThat(ended).as("the other look goes on").containsExactly("GreenObject");
  }

  @Test
  void aPickAndAPlaceAreSequencesOfActions() {
    List<WorldEvent.Kind> deeds = new ArrayList<>();
    homes
        .world()
        .listen(
            event -> {
              if (event.subject().equals("rose")) {
                deeds.add(event.kind());
              }
            });
    homes.call("rose", "pick", Map.of("object", homes.at("GreenObject")));
    homes.call(
        "rose",
        "place",
        Map.of("object", Homes.ref("GreenObject"), "target", homes.at("RedObject2")));
    Set<WorldEvent.Kind> once = new LinkedHashSet<>(deeds);
    once.remove(WorldEvent.Kind.DRAINED);
    assertThat(once)
        .containsExactly(
            WorldEvent.Kind.DRIVE,
            WorldEvent.Kind.DRIVEN,
            WorldEvent.Kind.GRASP,
            WorldEvent.Kind.PICKED,
            WorldEvent.Kind.RELEASE,
            WorldEvent.Kind.PLACED);
    assertThat(deeds.stream().filter(WorldEvent.Kind.DRIVE::equals))
        .as("one drive each")
        .hasSize(2);
  }

  /** Without base, feature or call: the hardware function alone. */
  @Test
  void theGripperWorksByItself() {
    GripperArm arm = homes.simulated.drivers("rose").find(GripperArm.class).orElseThrow();
    Position robot = homes.world().position("rose").orElseThrow();
    Position hand = new Position(robot.x() + arm.reach(), robot.y(), 0);
    homes.world().moveByHand("GreenObject", hand);
    Target green = new Target("GreenObject", Map.of());
    List<String> told = new ArrayList<>();

    arm.grasp(green, told("too far off", told));
    homes.clock.run(Duration.ofSeconds(2));
    arm.extend(hand, told("extended", told));
    homes.clock.run(Duration.ofSeconds(2));
    arm.grasp(green, told("closed", told));
    homes.clock.run(Duration.ofSeconds(2));
    assertThat(arm.held()).contains("GreenObject");
    arm.release(told("opened", told));
    homes.clock.run(Duration.ofSeconds(2));

    assertThat(arm.held()).isEmpty();
    assertThat(told)
        .containsExactly(
            "too far off: it is not where it was seen", "extended", "closed", "opened");
  }

  /** The same of a lamp. */
  @Test
  void theLampWorksByItself() {
    DimmableLamp lamp = homes.simulated.drivers("lamp-1").find(DimmableLamp.class).orElseThrow();
    List<String> told = new ArrayList<>();

    lamp.set(0.5, OptionalInt.empty(), told("dimmed", told));
    homes.clock.run(Duration.ofSeconds(1));

    assertThat(told).containsExactly("dimmed");
    assertThat(lamp.level()).isEqualTo(0.5);
    assertThat(homes.world().lampLevel("lamp-1")).isEqualTo(0.5);
  }

  /** By calls; which white it then has, its driver tells. */
  @Test
  void eachOfSixLampsShinesInFourWhites() {
    for (int number = 1; number <= 6; number++) {
      String id = "lamp-" + number;
      DimmableLamp lamp = homes.simulated.drivers(id).find(DimmableLamp.class).orElseThrow();
      assertThat(lamp.whites()).as(id).hasSize(4).doesNotHaveDuplicates();
      for (int white : lamp.whites()) {
        Result result =
            homes
                .call(id, "adjustLight", Map.of("level", 1, "white", white))
                .result()
                .orElseThrow();
        assertThat(result.outcome()).as("%s: %s", id, result).isEqualTo(Outcome.SUCCEEDED);
        assertThat(lamp.whiteKelvin()).as(id).isEqualTo(white);
      }
    }
  }

  private static Completion told(String what, List<String> told) {
    return new Completion() {
      @Override
      public void done() {
        told.add(what);
      }

      @Override
      public void failed(String reason) {
        told.add(what + ": " + reason);
      }
    };
  }
}
