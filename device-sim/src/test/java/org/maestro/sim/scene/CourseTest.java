package org.maestro.sim.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.home.Home;
import org.maestro.rats.protocol.Outcome;
import org.maestro.sim.Homes;

/** Faults and walks that a scene states. */
class CourseTest {

  private static final Home BOB = Homes.home("bob");

  private static Homes during(String said) {
    return new Homes(BOB, scene(said), 1);
  }

  private static Scene scene(String said) {
    String turtle =
        "@prefix scene: <%s> .\n<#rose> scene:position \"4 0.8 0\" .\n%s"
            .formatted(SceneLoader.NAMESPACE, said);
    return SceneLoader.load(
        "x.ttl", new ByteArrayInputStream(turtle.getBytes(StandardCharsets.UTF_8)), BOB);
  }

  @Test
  void happensAtItsTime() {
    try (Homes homes =
        during(
            "<#lamp-b1> scene:fault \"at 10 die; at 20 revive\" . <#door-ab> scene:fault \"at 15"
                + " close\" .<#zone-b> scene:fault \"at 5 ambient 120\" .")) {
      homes.clock.run(Duration.ofSeconds(6));
      assertThat(homes.world().lux("zone-b")).isCloseTo(120, within(1e-9));
      homes.clock.run(Duration.ofSeconds(6));
      assertThat(homes.world().isAlive("lamp-b1")).isFalse();
      assertThat(homes.world().isOpen("door-ab")).isTrue();
      homes.clock.run(Duration.ofSeconds(9));
      assertThat(homes.world().isAlive("lamp-b1")).isTrue();
      assertThat(homes.world().isOpen("door-ab")).isFalse();
    }
  }

  @Test
  void happensUponAnEvent() {
    try (Homes homes =
        during(
            "<#Cup> scene:position \"4.6 1.2 0\" ; scene:mass 0.2 . <#rose> scene:fault \"upon"
                + " picked drop\" .")) {
      homes.call("rose", "pick", Map.of("object", homes.at("Cup")));
      assertThat(homes.world().held("rose")).isEmpty();
      assertThat(homes.world().distance("Cup", "rose")).isLessThan(0.5);
    }
  }

  @Test
  void aFrozenDeviceDoesItsWorkLater() {
    try (Homes homes = during("<#lamp-b1> scene:fault \"at 1 freeze 10\" .")) {
      homes.clock.run(Duration.ofSeconds(2));
      Duration begun = homes.clock.now();
      var answer = homes.call("lamp-b1", "adjustLight", Map.of("level", 1));
      assertThat(answer.result().orElseThrow().outcome()).isEqualTo(Outcome.SUCCEEDED);
      assertThat(homes.clock.now().minus(begun).toMillis()).isBetween(8_800L, 9_500L);
    }
  }

  @Test
  void sensorsLieAndDrift() {
    try (Homes homes =
        during(
            "<#zone-a> scene:ambientLux 100 . <#zone-b> scene:ambientLux 100 .<#lux-a> scene:fault"
                + " \"at 1 lie 1.5\" . <#lux-b> scene:fault \"at 1 drift 0.5\" .")) {
      homes.clock.run(Duration.ofHours(1));
      assertThat(lux(homes, "lux-a")).isCloseTo(150, within(6.0));
      assertThat(lux(homes, "lux-b")).isCloseTo(150, within(6.0));
    }
  }

  private static double lux(Homes homes, String sensor) {
    return ((Number) homes.call(sensor, "measureIllumination", Map.of()).values().get("lux"))
        .doubleValue();
  }

  @Test
  void randomFaultsComeAtTheirRateAndAreTheSameForTheSameSeed() {
    List<Duration> first = closings(1);
    assertThat(first).isEqualTo(closings(1)).isNotEqualTo(closings(2));
    // ten in a minute: some 120 in twelve, within three standard deviations
    assertThat(first.size()).isBetween(87, 153);
  }

  private static List<Duration> closings(long seed) {
    List<Duration> at = new ArrayList<>();
    try (Homes homes = new Homes(BOB, scene("<#door-ab> scene:fault \"every 6 close\" ."), seed)) {
      homes.world().listen(event -> at.add(event.at()));
      homes.clock.run(Duration.ofMinutes(12));
    }
    return at;
  }

  @Test
  void personsWalkTheirRoundsAndStandInTheWay() {
    try (Homes homes =
        during(
            "<#Bob> scene:position \"1 2.35 0\" ; scene:radius 0.25 ; scene:walks \"3 2.35, 1"
                + " 2.35\" .")) {
      homes.clock.run(Duration.ofMillis(1150));
      // 0.8 m/s, and a tenth of a second until the members were there
      assertThat(homes.world().position("Bob").orElseThrow().x()).isCloseTo(2, within(0.01));
      homes.clock.run(Duration.ofMillis(1250));
      assertThat(homes.world().position("Bob").orElseThrow().floor().distance(new Point2(3, 2.35)))
          .isLessThan(0.05);
      assertThat(homes.world().whereabouts().obstacles("rose")).hasSize(1);
      homes.clock.run(Duration.ofMillis(2500));
      assertThat(homes.world().position("Bob").orElseThrow().x()).isLessThan(1.1);
    }
  }

  @Test
  void whoWalksMayStayAtACorner() {
    try (Homes homes =
        during(
            "<#Bob> scene:position \"1 2.35 0\" ; scene:radius 0.25 ; scene:walks \"3 2.35 10, 1"
                + " 2.35\" .")) {
      homes.clock.run(Duration.ofSeconds(12));
      assertThat(homes.world().position("Bob").orElseThrow().floor().distance(new Point2(3, 2.35)))
          .isLessThan(0.05);
      homes.clock.run(Duration.ofMillis(2500));
      assertThat(homes.world().position("Bob").orElseThrow().x()).isLessThan(2);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<#Bob> scene:position \"1 1 0\" ; scene:walks \"1 1 -5\" . | Nobody stays for -5 seconds",
        "<#lamp-b1> scene:fault \"die\" . | write when and what",
        "<#lamp-b1> scene:fault \"at 5 explode\" . | known are ambient, block, break",
        "<#lamp-b1> scene:fault \"at 5 lie\" . | takes 1 numbers, not 0",
        "<#lamp-b1> scene:fault \"at -5 die\" . | more than none",
        "<#lamp-b1> scene:fault \"upon rain die\" . | \"rain\" is not known",
        "<#Bob> scene:walks \"1 1\" . | does not say from where",
        "<#Bob> scene:roams 20 . | does not say from where",
        "<#Bob> scene:position \"1 1 0\" ; scene:roams 0.5 . | write 1 second or more",
        "<#Bob> scene:position \"1 1 0\" ; scene:roams \"often\" . | which is no number",
        "<#Bob> scene:position \"1 1 0\" ; scene:roams 20 ; scene:walks \"1 1\" . | leave out"
            + " scene:walks or scene:roams",
        "<> scene:roams 20 . | says something of the sky"
      })
  void whatCannotBeReadIsNamed(String said, String message) {
    assertThatThrownBy(() -> scene(said))
        .isInstanceOf(SimulationException.class)
        .hasMessageContaining(message);
  }
}
