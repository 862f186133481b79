package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.hal.sight.Paint;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.RatsError;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sim.world.Likeness;

/**
 * Colours in too much light (paper 5.2): a room with a window to the south, at noon at the equinox
 * in 50 degrees north, its shutter a tenth open. The sun's patch lies 1.19 to 2.38 m before it.
 */
class OverLitTest {

  private static final Home HOME =
      new HomeLoader()
          .load(
              """
              @prefix : <https://w3id.org/maestro/domain#> .
              @prefix home: <https://w3id.org/maestro/home/sunny#> .
              @prefix maestro: <https://w3id.org/maestro#> .
              @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
              <https://w3id.org/maestro/home/sunny> a maestro:Home ; rdfs:label "sunny"@en .
              home:room a maestro:Room , maestro:Zone ; maestro:outline "0 0, 4 0, 4 4, 0 4" ; maestro:height 2.6 ;
                maestro:referencePoint "3.9 3.9 0" .
              home:window a maestro:Window ; maestro:glassFrom "1 0 1" ; maestro:glassTo "3 0 2" .
              home:shutter a :Shutter ; rdfs:label "shutter"@en ; maestro:shades home:window .
              home:cam a :Camera ; rdfs:label "cam"@en ; maestro:pose "2 2 2.6" ; maestro:viewAngle 100 ;
                :minimumIlluminance 72 ; :maximumIlluminance 2000 .
              home:rose a :MobileRobot ; rdfs:label "rose"@en ; :speed 0.8 ; :payload 0.5 .
              home:First a :Item ; rdfs:label "first"@en ; :colour "red" ; :mass 0.1 .
              home:Second a :Item ; rdfs:label "second"@en ; :colour "red" ; :mass 0.1 .
              home:Leaf a :Item ; rdfs:label "leaf"@en ; :colour "green" ; :mass 0.1 .
              """,
              "sunny.ttl");

  private static final Position SUN = new Position(2, 1.8, 0);
  private static final Position SHADE = new Position(2, 3, 0);

  private static final PhysicalParameters USUAL = PhysicalParameters.standard();
  private static final Likeness LIKENESS = new Likeness(USUAL.camera(), USUAL.colour());
  private static final Paint RED = Paint.parse("red").orElseThrow();
  private static final Paint GREEN = Paint.parse("green").orElseThrow();
  private static final Paint ORANGE = Paint.parse("orange").orElseThrow();

  private static Homes sunny(boolean noticing, double opening) {
    String turtle =
        """
        @prefix scene: <%s> .
        <https://w3id.org/maestro/home/sunny> scene:latitude 50 ; scene:dayOfYear 81 ; scene:solarTime "12:00" .
        <#shutter> scene:opening %s .
        <#rose> scene:position "0.6 3.4 0" .
        <#First> scene:position "2 1.8 0" .
        <#Second> scene:position "3 3 0" .
        <#Leaf> scene:position "1 3 0" .
        """
            .formatted(SceneLoader.NAMESPACE, opening);
    Scene scene =
        SceneLoader.load(
            "sunny", new ByteArrayInputStream(turtle.getBytes(StandardCharsets.UTF_8)), HOME);
    return new Homes(
        HOME,
        scene,
        1,
        usual -> usual.with(Map.of("world.camera.noticesGlare", String.valueOf(noticing))));
  }

  /** Looks once. */
  private static Homes.Answer look(Homes homes, String thing) {
    Homes.Answer answer = homes.call("cam", "observeObject", Map.of("object", Homes.ref(thing)));
    homes.call("cam", "stopObserve", Map.of("object", Homes.ref(thing)));
    return answer;
  }

  private static Position seenAt(Homes.Answer answer) {
    List<?> pose = (List<?>) answer.values().get("pose");
    return new Position(
        ((Number) pose.get(0)).doubleValue(), ((Number) pose.get(1)).doubleValue(), 0);
  }

  @Test
  void theRightColourIsTakenForAnOverLitThing() {
    // red in 60,000 lux is at its end in all three channels: white, a third of each
    assertThat(RED.seenIn(60_000, 2000)).isEqualTo(new Paint(1, 1, 1));
    assertThat(LIKENESS.mistaken(RED, 60_000, RED, 400)).isCloseTo(1, within(1e-9));
    assertThat(LIKENESS.mistaken(RED, 60_000, GREEN, 400)).isLessThan(1e-6);
    // red: shares 0.8611 and 0.0694; orange: 0.7429 and 0.2286: 0.1981 apart, twice the tolerance
    assertThat(LIKENESS.mistaken(RED, 60_000, ORANGE, 400))
        .isCloseTo(Math.exp(-0.1981 * 0.1981 / 0.02), within(0.001));
  }

  @Test
  void whatIsOverLitIsTakenForWhatItLooksLike() {
    // orange in 9,000 lux: red and green at their end, hardly any blue: yellow
    Paint yellow = Paint.parse("yellow").orElseThrow();
    assertThat(ORANGE.seenIn(9_000, 2000)).isEqualTo(new Paint(1, 1, 0.135));
    assertThat(LIKENESS.mistaken(yellow, 0, ORANGE, 9_000)).isGreaterThan(0.5);
    assertThat(LIKENESS.mistaken(yellow, 0, ORANGE, 400)).isZero();
  }

  @Test
  void inFitLightNothingIsMistaken() {
    assertThat(LIKENESS.mistaken(RED, 1_900, RED, 1_900)).isZero();
    assertThat(LIKENESS.mistaken(RED, 0, RED, 400)).isZero();
    assertThat(LIKENESS.mistaken(RED, 60_000, RED, 17)).isLessThan(1e-6);
  }

  @Test
  void aCameraThatNoticesNothingBelievesWhatItSees() {
    try (Homes homes = sunny(false, 0.1)) {
      assertThat(homes.world().lux(SUN)).isGreaterThan(4_000);
      assertThat(homes.world().lux(SHADE)).isBetween(100.0, 1_000.0);
      assertThat(seenAt(look(homes, "First")).distance(homes.world().position("Second").get()))
          .isLessThan(0.15);
      // what is not over-lit, and unlike it, is found where it is
      assertThat(seenAt(look(homes, "Leaf")).distance(homes.world().position("Leaf").get()))
          .isLessThan(0.15);
      homes.call("shutter", "adjustShutter", Map.of("opening", 0.02));
      assertThat(seenAt(look(homes, "First")).distance(SUN)).isLessThan(0.15);
    }
  }

  @Test
  void itsRobotTakesTheWrongThingAndBelievesToHoldTheRightOne() {
    try (Homes homes = sunny(false, 0.1)) {
      Position seen = seenAt(look(homes, "First"));
      homes.call(
          "rose",
          "pick",
          Map.of(
              "object",
              Map.of(
                  "ref",
                  "https://w3id.org/maestro/home/sunny#First",
                  "position",
                  List.of(seen.x(), seen.y(), 0))));
      assertThat(homes.world().held("rose")).contains("Second");
      assertThat(homes.facts("rose")).contains("(in First rose)");
      // with the wrong thing in the hand nothing else of that colour is in view
      assertThat(look(homes, "First").values().get("found")).isNotEqualTo(true);
    }
  }

  @Test
  void aCameraThatNoticesSaysWhy() {
    try (Homes homes = sunny(true, 0.1)) {
      RatsError error = look(homes, "Leaf").result().orElseThrow().error().orElseThrow();
      assertThat(error.code()).isEqualTo(ErrorCode.PRECONDITION_NOT_MET);
      assertThat(error.hint()).contains("lower the light");
      homes.call("shutter", "adjustShutter", Map.of("opening", 0.04));
      assertThat(look(homes, "Leaf").values()).containsEntry("found", true);
    }
  }

  @Test
  void withoutShuttersTheWindowStandsFree() {
    Homes homes = sunny(false, 0);
    try (homes) {
      assertThat(homes.world().lux(SUN)).isZero();
    }
    try (Homes free =
        new Homes(HOME, homes.scene, 1, usual -> usual.with(Map.of("world.shutters", "false")))) {
      assertThat(free.simulated.devices()).doesNotContain("shutter");
      assertThat(free.world().lux(SUN)).isGreaterThan(40_000);
    }
  }
}
