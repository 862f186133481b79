package org.maestro.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.sim.Homes;
import org.maestro.sim.scene.ScriptedFault;
import org.maestro.sim.scene.WorldEvent;

/** Faults that are let happen while Bob's home runs. */
class FaultsTest {

  private static void let(Homes homes, String subject, String fault) {
    homes.simulated.let(subject, ScriptedFault.parse(fault));
  }

  private static Result call(Homes homes, String member, String feature, Map<String, Object> with) {
    return homes.call(member, feature, with).result().orElseThrow();
  }

  private static Homes.Answer lux(Homes homes) {
    return homes.call("lux-b", "measureIllumination", Map.of());
  }

  @Test
  void wheelsThatSlipTakeLonger() {
    try (Homes homes = Homes.bob("bob-lit")) {
      let(homes, "rose", "at 0.001 slip 0.5");
      homes.clock.run(Duration.ofSeconds(1));
      call(homes, "rose", "move", Map.of("to", Homes.ref("zone-a")));
      List<PathPoint> path = homes.world().path("rose");
      double metres = 0;
      for (int i = 1; i < path.size(); i++) {
        metres += path.get(i - 1).point().distance(path.get(i).point());
      }
      Duration took = path.get(path.size() - 1).at().minus(path.get(0).at());
      assertThat(metres).isGreaterThan(1);
      assertThat(took.toMillis() / 1e3).isCloseTo(metres / 0.4, within(0.01));
      let(homes, "rose", "at 0.001 slip 1");
      homes.clock.run(Duration.ofSeconds(1));
      Result stuck = call(homes, "rose", "move", Map.of("to", Homes.ref("zone-a")));
      assertThat(stuck.error().orElseThrow().message()).contains("do not grip");
    }
  }

  @Test
  void aLinkThatLosesAllIsSilent() {
    try (Homes homes = Homes.bob("bob-lit")) {
      let(homes, "lux-b", "at 0.001 lose 1");
      homes.clock.run(Duration.ofSeconds(1));
      assertThat(lux(homes).result().orElseThrow().outcome()).isEqualTo(Outcome.TIMED_OUT);
      let(homes, "lux-b", "at 0.001 lose 0");
      homes.clock.run(Duration.ofSeconds(1));
      assertThat(lux(homes).values()).containsKey("lux");
    }
  }

  @Test
  void aLinkThatDelaysAnswersLater() {
    try (Homes homes = Homes.bob("bob-lit")) {
      let(homes, "lamp-b1", "at 0.001 delay 2");
      homes.clock.run(Duration.ofSeconds(1));
      Duration begun = homes.clock.now();
      call(homes, "lamp-b1", "adjustLight", Map.of("level", 0));
      // 2 s there, 0.4 s for the lamp, 2 s back
      assertThat(homes.clock.now().minus(begun).toMillis()).isBetween(4_400L, 4_500L);
    }
  }

  @Test
  void whatComesTwiceIsDoneOnce() {
    try (Homes homes = Homes.bob("bob-lit")) {
      List<WorldEvent> lit = new ArrayList<>();
      let(homes, "lamp-b1", "at 0.001 duplicate 1");
      homes.clock.run(Duration.ofSeconds(1));
      homes.world().listen(lit::add);
      call(homes, "lamp-b1", "adjustLight", Map.of("level", 0.5));
      homes.clock.run(Duration.ofSeconds(5));
      assertThat(lit).filteredOn(event -> event.kind() == WorldEvent.Kind.LIT).hasSize(1);
    }
  }

  @Test
  void membersAndTheBrokerGoAndComeBack() {
    try (Homes homes = Homes.bob("bob-lit")) {
      let(homes, "lamp-b1", "at 1 offline");
      let(homes, "lamp-b1", "at 2 online");
      homes.clock.run(Duration.ofMillis(1_500));
      assertThat(phase(homes, "lamp-b1")).isEqualTo(MemberStatus.Phase.LOST);
      assertThat(homes.world().lampLevel("lamp-b1")).isEqualTo(1);
      homes.clock.run(Duration.ofSeconds(1));
      assertThat(phase(homes, "lamp-b1")).isEqualTo(MemberStatus.Phase.READY);
      let(homes, "", "at 1 offline");
      let(homes, "", "at 2 online");
      homes.clock.run(Duration.ofSeconds(3));
      assertThat(phase(homes, "rose")).isEqualTo(MemberStatus.Phase.READY);
      assertThat(lux(homes).values()).containsKey("lux");
    }
  }

  private static MemberStatus.Phase phase(Homes homes, String id) {
    return homes.link.members().stream()
        .filter(member -> member.id().equals(id))
        .findFirst()
        .orElseThrow()
        .phase();
  }

  @Test
  void aHandLetsGoOfWhatItHolds() {
    try (Homes homes = Homes.bob("bob-lit")) {
      call(homes, "rose", "pick", Map.of("object", homes.at("Cup")));
      let(homes, "rose", "at 1 drop");
      homes.clock.run(Duration.ofSeconds(2));
      assertThat(homes.world().holder("Cup")).isEmpty();
      assertThat(homes.world().isAlive("rose")).isTrue();
      Result placed =
          call(
              homes,
              "rose",
              "place",
              Map.of("object", Homes.ref("Cup"), "target", homes.at("Bob")));
      assertThat(placed.error().orElseThrow().refs().get(0).fact()).isEqualTo("(in Cup rose)");
    }
  }

  @Test
  void theSunComesOut() {
    try (Homes homes = new Homes("arena-windows", "arena-windows", 1, scene -> scene)) {
      homes.simulated.let("", ScriptedFault.parse("at 1 clouds 1"));
      homes.simulated.let("", ScriptedFault.parse("at 3 clouds 0"));
      homes.clock.run(Duration.ofSeconds(2));
      double covered = brightest(homes);
      homes.clock.run(Duration.ofSeconds(2));
      assertThat(brightest(homes)).as("lux on the floor").isGreaterThan(10 * covered);
    }
  }

  private static double brightest(Homes homes) {
    double most = 0;
    for (double x = 0.2; x < 8.4; x += 0.2) {
      for (double y = 0.2; y < 3; y += 0.2) {
        most =
            Math.max(
                most, homes.world().daylightWithOpenShutters(Position.onFloor(new Point2(x, y))));
      }
    }
    return most;
  }

  @Test
  void aRoomGoesDark() {
    try (Homes homes = Homes.bob("bob-lit")) {
      let(homes, "zone-b", "at 1 dark");
      homes.clock.run(Duration.ofSeconds(2));
      assertThat(homes.world().lux("zone-b")).isZero();
      assertThat(homes.world().isAlive("lamp-b1")).isFalse();
      assertThat(homes.world().isAlive("lamp-a1")).isTrue();
    }
  }

  @Test
  void aPersonBlocksTheDoorWhenTheRobotHasPicked() {
    try (Homes homes = Homes.bob("bob-lit")) {
      let(homes, "Bob", "upon rose.picked block door-ab");
      call(homes, "rose", "pick", Map.of("object", homes.at("Cup")));
      assertThat(homes.world().position("Bob").orElseThrow().floor())
          .extracting(place -> place.distance(new Point2(3, 2.35)) < 1e-9)
          .isEqualTo(true);
      Result move = call(homes, "rose", "move", Map.of("to", Homes.ref("zone-a")));
      assertThat(move.error().orElseThrow().code()).isEqualTo(ErrorCode.PRECONDITION_NOT_MET);
    }
  }

  @Test
  void whatIsTakenAwayAndBroughtBackIsSeenAgain() {
    try (Homes homes = Homes.bob("bob-lit")) {
      let(homes, "Cup", "at 1 hide");
      let(homes, "Cup", "at 2 show");
      homes.clock.run(Duration.ofMillis(1_500));
      assertThat(homes.world().isHidden("Cup")).isTrue();
      homes.clock.run(Duration.ofSeconds(1));
      assertThat(homes.world().isHidden("Cup")).isFalse();
    }
  }

  @Test
  void anEmptyRobotStopsAndLetsGo() {
    try (Homes homes = Homes.bob("bob-lit")) {
      call(homes, "rose", "pick", Map.of("object", homes.at("Cup")));
      List<WorldEvent.Kind> kinds = new ArrayList<>();
      homes.world().listen(event -> kinds.add(event.kind()));
      let(homes, "rose", "at 1 charge 0.001");
      // 0.1 % of 120 Wh is 432 J, which 20 W draw in 21.6 s
      homes.clock.run(Duration.ofSeconds(15));
      assertThat(homes.facts("rose")).contains("(= (charge rose) 0.05)");
      assertThat(homes.world().isAlive("rose")).isTrue();
      homes.clock.run(Duration.ofSeconds(15));
      assertThat(homes.world().isAlive("rose")).isFalse();
      assertThat(homes.world().holder("Cup")).isEmpty();
      assertThat(kinds).contains(WorldEvent.Kind.EMPTIED, WorldEvent.Kind.DROPPED);
      assertThat(phase(homes, "rose")).isEqualTo(MemberStatus.Phase.LOST);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "lamp-b1 | at 5 drop | The fault drop is for a robot, not for lamp-b1.",
        "rose | at 5 weaken 0.5 | is for a lamp, not for rose",
        "rose | at 5 clouds 1 | is for the home itself, not for rose",
        "Bob | at 5 block rose | names no door of this home; there are [door-ab]",
        "rose | upon tim.picked die | waits for tim, which the home does not have",
        "rose | at 5 move 1 | takes 2 numbers, not 1",
        "Bob | at 5 block | takes 1 name, not 0",
        "rose | at 5 slip 2 | 2 is not between 0 and 1"
      })
  void whatCannotHappenIsNamed(String subject, String fault, String message) {
    try (Homes homes = Homes.bob("bob-lit")) {
      assertThatThrownBy(() -> let(homes, subject, fault)).hasMessageContaining(message);
    }
  }

  @Test
  void everythingElseGoesOn() {
    try (Homes homes = Homes.bob("bob-lit")) {
      let(homes, "rose", "at 1 freeze 3");
      assertThat(call(homes, "lamp-b1", "adjustLight", Map.of("level", 0)).outcome())
          .isEqualTo(Outcome.SUCCEEDED);
    }
  }
}
