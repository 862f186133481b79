package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.device.Nameplate;
import org.maestro.hal.Completion;
import org.maestro.hal.GripperArm;
import org.maestro.hal.JammingGripper;
import org.maestro.hal.Position;
import org.maestro.hal.Target;
import org.maestro.hal.sight.Size;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.sim.parameters.GripperData;
import org.maestro.sim.world.Wrap;
import org.maestro.sl.Term;

class JammingGripperTest {

  private static final Size CUBE = new Size(0.06, 0.06, 0.06);

  private static Wrap wrap(double length, double width, double height) {
    return new Wrap(GripperData.USUAL, new Size(length, width, height));
  }

  /**
   * Ball of radius 5 cm, pinch 0.1 of 75 kPa, friction 1, 1 cm of lip. A cube of 6 cm: the ball
   * reaches down sqrt(25 - 9) = 4 cm, 3 of which bear; two sides of 6 cm: 36 square centimetres. A
   * cup 8 cm wide: it reaches 3 cm, 2 of which bear, upon 6 cm of breadth: 24. A shard 2 cm high:
   * two sides of 4 cm, 1 cm deep: 8. A ruler is held across.
   */
  @ParameterizedTest
  @CsvSource({
    "0.06, 0.06, 0.06, 27.0",
    "0.08, 0.08, 0.10, 18.0",
    "0.04, 0.04, 0.02, 6.0",
    "0.30, 0.06, 0.02, 12.0",
    "0.06, 0.30, 0.02, 12.0"
  })
  void bearsWhatItsStiffSidesPinch(double length, double width, double height, double newtons) {
    assertThat(wrap(length, width, height).force()).isCloseTo(newtons, within(1e-9));
  }

  @Test
  void bearsNothingThatItCannotWrap() {
    assertThat(wrap(0.12, 0.1, 0.1).failure(0.1)).contains("it is too large for a bag of 10 cm");
    assertThat(wrap(0.099, 0.099, 0.1).failure(0.1)).contains("it is too large for a bag of 10 cm");
    assertThat(wrap(0.06, 0.06, 0.01).failure(0.01))
        .contains("it is too flat for the bag to get around it");
    assertThat(wrap(0.06, 0.06, 0.011).failure(0.01)).isEmpty();
  }

  /** 6 N bear 0.61 kg and not 0.62 kg: 9.81 N a kilogram. */
  @Test
  void bearsNoMoreThanItsForce() {
    assertThat(wrap(0.04, 0.04, 0.02).failure(0.61)).isEmpty();
    assertThat(wrap(0.04, 0.04, 0.02).failure(0.62))
        .contains("it slips out of the bag, which bears 6.0 N of 6.1 N");
  }

  @Test
  void eachNumberOfItMatters() {
    assertThat(new Wrap(new GripperData(0.1, 37.5, 0.1, 1, 0.01, 1, 1, 1), CUBE).force())
        .isCloseTo(13.5, within(1e-9));
    assertThat(new Wrap(new GripperData(0.1, 75, 0.1, 0.5, 0.01, 1, 1, 1), CUBE).force())
        .isCloseTo(13.5, within(1e-9));
    assertThat(new Wrap(new GripperData(0.1, 75, 0.1, 1, 0, 1, 1, 1), CUBE).force())
        .isCloseTo(36, within(1e-9));
  }

  @Test
  void isSoftThenStiffWhileItHoldsAndSoftAgain() {
    try (Homes homes = Homes.bob("bob-lit")) {
      GripperArm arm = homes.simulated.drivers("rose").find(GripperArm.class).orElseThrow();
      JammingGripper gripper =
          homes.simulated.drivers("rose").find(JammingGripper.class).orElseThrow();
      Position rose = homes.world().position("rose").orElseThrow();
      Position hand = new Position(rose.x(), rose.y() - arm.reach(), 0);
      homes.world().moveByHand("Cup", hand);
      List<String> told = new ArrayList<>();

      arm.extend(hand, told("extended", told));
      homes.clock.run(Duration.ofSeconds(2));
      arm.grasp(new Target("Cup", Map.of()), told("gripped", told));
      homes.clock.run(Duration.ofMillis(500));
      assertThat(gripper.pressure()).as("pressed").isZero();
      homes.clock.run(Duration.ofMillis(500));
      assertThat(gripper.pressure()).as("half of a second later").isCloseTo(-37.5, within(0.1));
      assertThat(gripper.isEvacuated()).isFalse();
      homes.clock.run(Duration.ofMillis(501));
      assertThat(gripper.pressure()).isEqualTo(-75);
      assertThat(gripper.isHolding()).isTrue();
      assertThat(arm.held()).contains("Cup");
      arm.release(told("released", told));
      homes.clock.run(Duration.ofMillis(501));
      assertThat(gripper.pressure()).isZero();
      assertThat(gripper.isHolding()).isFalse();
      assertThat(told).containsExactly("extended", "gripped", "released");
    }
  }

  /** A command that replaces another ends what the bag does. */
  @Test
  void takesNothingOnceTheArmDoesSomethingElse() {
    try (Homes homes = Homes.bob("bob-lit")) {
      GripperArm arm = homes.simulated.drivers("rose").find(GripperArm.class).orElseThrow();
      Position rose = homes.world().position("rose").orElseThrow();
      Position hand = new Position(rose.x(), rose.y() - arm.reach(), 0);
      homes.world().moveByHand("Cup", hand);
      List<String> told = new ArrayList<>();
      arm.extend(hand, told("extended", told));
      homes.clock.run(Duration.ofSeconds(2));
      arm.grasp(new Target("Cup", Map.of()), told("gripped", told));
      homes.clock.run(Duration.ofSeconds(1));
      arm.fold(told("folded", told));
      homes.clock.run(Duration.ofSeconds(2));
      assertThat(told).containsExactly("extended", "folded");
      assertThat(arm.held()).isEmpty();
    }
  }

  @Test
  void whatOneHandCannotHoldAnotherTakes() {
    Map<String, String> saucer = Map.of("\"0.08 0.08 0.1\"", "\"0.06 0.06 0.008\"");
    assertThat(picked(saucer, "mobile-robot").error().orElseThrow().message())
        .isEqualTo("Cannot grasp Cup: it is too flat for the bag to get around it.");
    assertThat(picked(saucer, "mobile-robot-with-fingers").outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(picked(Map.of(), "mobile-robot").outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(picked(Map.of(), "mobile-robot-with-fingers").error().orElseThrow().message())
        .isEqualTo("Cannot grasp Cup: it is too large for fingers that open 7 cm.");
  }

  /** The bag of 10 cm gets around what leaves 1 cm of its lip. */
  @Test
  void aRobotSaysHowWideItsHandOpensUnlessTheHomeDoes() {
    assertThat(saysOfItsOpening("")).containsExactly(new Term.Number(0.098));
    assertThat(saysOfItsOpening("; :gripperOpening 0.05")).containsExactly(new Term.Number(0.05));
    assertThat(saysOfItsOpening("; maestro:driver \"mobile-robot-with-fingers\""))
        .containsExactly(new Term.Number(0.07));
  }

  private static List<Term> saysOfItsOpening(String stated) {
    Home home =
        new HomeLoader()
            .load(Homes.text("bob").replace("; :gripperOpening 0.098", stated), "bob.ttl");
    try (Homes homes = new Homes(home, Homes.scene("bob-lit", home), 1)) {
      return Nameplate.on(home.devices().get("rose"), homes.simulated.drivers("rose"))
          .individual()
          .properties()
          .get("gripperOpening");
    }
  }

  private static Result picked(Map<String, String> changes, String driver) {
    String text = Homes.text("bob").replace(" ; :gripperOpening 0.098", "");
    for (Map.Entry<String, String> change : changes.entrySet()) {
      text = text.replace(change.getKey(), change.getValue());
    }
    text =
        text.replace(
            "home:rose a :MobileRobot ;",
            "home:rose a :MobileRobot ; maestro:driver \"" + driver + "\" ;");
    Home home = new HomeLoader().load(text, "bob.ttl");
    try (Homes homes = new Homes(home, Homes.scene("bob-lit", home), 1)) {
      return homes.call("rose", "pick", Map.of("object", homes.at("Cup"))).result().orElseThrow();
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
