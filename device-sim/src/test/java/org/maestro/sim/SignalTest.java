package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.home.Home;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.SignalMap;

/** A signal with one peak, a field that tells it, and a robot that transmits where it suffices. */
class SignalTest {
  private static final Map<String, Object> OF_THE_ROVER = Map.of("robot", Homes.ref("rover"));

  private static Homes exploration(long seed) {
    Home home = Homes.home("exploration");
    return new Homes(home, Homes.scene("exploration", home), seed);
  }

  @Test
  void theSeedChoosesItsPlaceAwayFromTheRim() {
    Set<Point2> peaks = new HashSet<>();
    for (long seed = 1; seed <= 5; seed++) {
      try (Homes homes = exploration(seed);
          Homes again = exploration(seed)) {
        Point2 peak = homes.world().signal().peak();
        assertThat(again.world().signal().peak()).isEqualTo(peak);
        assertThat(peak.x()).isBetween(2.0, 18.0);
        assertThat(peak.y()).isBetween(2.0, 18.0);
        peaks.add(peak);
      }
    }
    assertThat(peaks).hasSize(5);
  }

  @Test
  void itFallsWithTheDistanceFromItsPeak() {
    try (Homes homes = exploration(1)) {
      SignalMap map = homes.world().signal();
      Point2 peak = map.peak();
      assertThat(map.strength(peak)).isEqualTo(100);
      assertThat(map.strength(peak.plus(5, 0))).isCloseTo(50, within(1e-9));
      assertThat(map.strength(peak.plus(0, map.reachMetres()))).isCloseTo(80, within(1e-9));
      double before = 101;
      for (double metres = 0; metres < 30; metres += 0.5) {
        double strength = map.strength(peak.plus(metres * 0.6, metres * 0.8));
        assertThat(strength).isLessThan(before).isPositive();
        before = strength;
      }
    }
  }

  @Test
  void aReadingIsThatOfThePlaceWhereTheRobotIs() {
    try (Homes homes = exploration(1)) {
      Point2 peak = homes.world().signal().peak();
      for (double metres : List.of(0.0, 2.0, 5.0, 9.0)) {
        Point2 place = peak.plus(peak.x() > 10 ? -metres : metres, 0);
        homes.world().moveByHand("rover", Position.onFloor(place));
        assertThat(homes.call("field", "readSignal", OF_THE_ROVER).values())
            .containsEntry("strength", Math.floor(homes.world().signal().strength(place)));
      }
    }
  }

  @Test
  void dataIsSentWhereItSufficesAndNowhereElse() {
    try (Homes homes = exploration(1)) {
      Set<WorldEvent.Kind> told = new HashSet<>();
      homes.world().listen(event -> told.add(event.kind()));
      SignalMap map = homes.world().signal();
      double toTheMiddle = map.peak().x() > 10 ? -1 : 1;

      Point2 outside = map.peak().plus(toTheMiddle * (map.reachMetres() + 0.01), 0);
      homes.world().moveByHand("rover", Position.onFloor(outside));
      Result refused = homes.call("rover", "transmit", Map.of()).result().orElseThrow();
      assertThat(refused.outcome()).isEqualTo(Outcome.FAILED);
      assertThat(refused.error().orElseThrow().message())
          .isEqualTo("The signal is 79 here, and has to be 80 at least.");
      assertThat(told).doesNotContain(WorldEvent.Kind.TRANSMITTED);

      Point2 inside = map.peak().plus(toTheMiddle * (map.reachMetres() - 0.01), 0);
      homes.world().moveByHand("rover", Position.onFloor(inside));
      assertThat(homes.call("rover", "transmit", Map.of()).result().orElseThrow().outcome())
          .isEqualTo(Outcome.SUCCEEDED);
      assertThat(told).contains(WorldEvent.Kind.TRANSMITTED);
    }
  }
}
