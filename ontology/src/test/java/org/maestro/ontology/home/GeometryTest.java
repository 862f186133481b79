package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Pose;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.SlParser;
import org.maestro.sl.Truth;

class GeometryTest {

  private final Home bob = ShippedHomes.bob();
  private final Geometry geometry = new Geometry(bob);
  private final Facts facts = new HomeFacts(bob);

  @Test
  void calculatesLightByHand() {
    // lamp-b1 at (4.1, 1.5, 2.8), 505 cd; reference point (5.9, 0.1, 0)
    double horizontal = Math.hypot(1.8, 1.4);
    double slant = Math.hypot(horizontal, 2.8);
    assertThat(geometry.luxAt("lamp-b1", "zone-b", Positions.UNKNOWN).orElseThrow())
        .isCloseTo(505 * 2.8 / Math.pow(slant, 3), within(1e-9))
        .isCloseTo(30, within(0.1));
    assertThat(number("(gain lamp-b2 zone-b)")).isCloseTo(35, within(0.1));
    assertThat(number("(gain lamp-b3 zone-b)")).isCloseTo(28, within(0.1));
    assertThat(number("(gain lamp-a1 zone-a)")).isCloseTo(40, within(0.1));
    assertThat(number("(gain lamp-a1 zone-b)")).isZero();
    assertThat(number("(gain lamp-b1 zone-a)")).isZero();
    assertThat(number("(gain cam-a zone-a)")).isZero();
  }

  @Test
  void camerasCoverTheirZonesAndNoOthers() {
    assertThat(truth("(covers cam-a zone-a)")).isEqualTo(Truth.TRUE);
    assertThat(truth("(covers cam-a zone-b)")).isEqualTo(Truth.FALSE);
    assertThat(truth("(covers lamp-a1 zone-a)")).isEqualTo(Truth.FALSE);
    // A circle of radius h tan(30 degrees) within the square of 9 square metres.
    Home narrow =
        new HomeLoader()
            .load(
                ShippedHomes.text("bob.ttl")
                    .replace(" ; maestro:watched true", "")
                    .replaceFirst("maestro:viewAngle 75", "maestro:viewAngle 50"),
                "bob.ttl");
    double radius = 2.8 * Math.tan(Math.toRadians(25));
    assertThat(new Geometry(narrow).viewShare("cam-a", "zone-a", Positions.UNKNOWN).orElseThrow())
        .isCloseTo(Math.PI * radius * radius / 9, within(0.02));
  }

  @Test
  void sensorsSpeakForTheirZone() {
    assertThat(truth("(senses lux-b zone-b)")).isEqualTo(Truth.TRUE);
    assertThat(truth("(senses lux-b zone-a)")).isEqualTo(Truth.FALSE);
    Facts arena = new HomeFacts(ShippedHomes.arena());
    for (String zone : List.of("zone-1", "zone-2", "zone-3")) {
      assertThat(
              new Evaluation(arena)
                  .truth(SlParser.formula("(senses lux-1 " + zone + ")"), Map.of()))
          .isEqualTo(Truth.TRUE);
    }
  }

  @Test
  void findsTheWayThroughTheDoor() {
    // From one room's middle to the door's middle and on to the other's.
    double byTheDoor = 2 * Math.hypot(1.5, 2.35 - 1.5);
    assertThat(number("(pathLength zone-a zone-b)")).isCloseTo(byTheDoor, within(1e-9));
    assertThat(number("(pathLength zone-a zone-a)")).isZero();
    Positions inB =
        name -> name.equals("rose") ? Optional.of(Pose.parse("4.5 2.5 0")) : Optional.empty();
    assertThat(geometry.shortestPath("rose", "zone-b", inB)).hasValue(1);
    assertThat(geometry.shortestPath("rose", "zone-b", Positions.UNKNOWN)).isEmpty();
  }

  @Test
  void findsNoWayThroughWalls() {
    Home walled =
        new HomeLoader()
            .load(
                ShippedHomes.text("bob.ttl")
                    .replace("maestro:openingFrom \"3 1.9\" ; maestro:openingTo \"3 2.8\" ;", ""),
                "bob.ttl");
    assertThat(new Geometry(walled).shortestPath("zone-a", "zone-b", Positions.UNKNOWN)).isEmpty();
  }

  @Test
  void goesAroundCorners() {
    Home corner =
        new HomeLoader()
            .load(
                """
                @prefix maestro: <https://w3id.org/maestro#> .
                @prefix home: <https://w3id.org/maestro/home/corner#> .
                <https://w3id.org/maestro/home/corner> a maestro:Home .
                home:room a maestro:Room ; maestro:outline "0 0, 4 0, 4 1, 1 1, 1 4, 0 4" .
                home:right a maestro:Zone ; maestro:outline "1 0, 4 0, 4 1, 1 1" .
                home:top a maestro:Zone ; maestro:outline "0 1, 1 1, 1 4, 0 4" .
                """,
                "corner.ttl");
    double around = Math.hypot(1.5, 0.5) + Math.hypot(0.5, 1.5);
    assertThat(new Geometry(corner).shortestPath("right", "top", Positions.UNKNOWN).orElseThrow())
        .isBetween(around, around + 2 * 0.3);
  }

  @Test
  void tellsTheSameLengthWhateverWasAskedBefore() {
    List<Point2> places = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      places.add(new Point2(0.2 + 1.1 * i % 5.7, 0.3 + 0.7 * i % 2.5));
    }
    for (Point2 from : places) {
      for (Point2 to : places) {
        assertThat(between(from, to, geometry)).isEqualTo(between(from, to, new Geometry(bob)));
      }
    }
  }

  private static OptionalDouble between(Point2 from, Point2 to, Geometry asked) {
    Map<String, Point2> where = Map.of("rose", from, "Cup", to);
    return asked.shortestPath(
        "rose",
        "Cup",
        name ->
            Optional.ofNullable(where.get(name)).map(at -> new Pose(at.x(), at.y(), 0, 0, 0, 0)));
  }

  @Test
  void knowsWhereFixedThingsAreAndNotWhereOthersAre() {
    assertThat(truth("(inside cam-b zone-b)")).isEqualTo(Truth.TRUE);
    assertThat(truth("(inside Cup zone-b)")).isEqualTo(Truth.UNKNOWN);
    assertThat(truth("(in Cup zone-b)")).isEqualTo(Truth.UNKNOWN);
    assertThat(truth("(passable zone-a zone-b)")).isEqualTo(Truth.TRUE);
    assertThat(truth("(passable zone-a zone-a)")).isEqualTo(Truth.FALSE);
    assertThat(truth("(handFree rose)")).isEqualTo(Truth.TRUE);
    assertThat(truth("(usuallyIn Bob zone-a)")).isEqualTo(Truth.TRUE);
    assertThat(truth("(unknown (illuminance zone-a))")).isEqualTo(Truth.TRUE);
    assertThat(truth("(Thing rose)")).isEqualTo(Truth.TRUE);
    assertThat(truth("(Thing lamp-a1)")).isEqualTo(Truth.FALSE);
  }

  @Test
  void theCheapestLampsThatLiftRoomBOverTheThresholdAreB1AndB2() {
    List<String> lamps = List.of("lamp-b1", "lamp-b2", "lamp-b3");
    double[] levels = {0, 0.25, 0.5, 1};
    for (double ambient : new double[] {16, 17, 19}) {
      double cheapest = Double.MAX_VALUE;
      List<Double> best = new ArrayList<>();
      for (int choice = 0; choice < 64; choice++) {
        List<Double> chosen = new ArrayList<>();
        double lux = ambient;
        double cost = 0;
        for (int lamp = 0; lamp < 3; lamp++) {
          double level = levels[choice >> 2 * lamp & 3];
          chosen.add(level);
          if (level > 0) {
            lux += level * number("(gain " + lamps.get(lamp) + " zone-b)");
            cost += 0.3 + 0.1 * level * number("(power " + lamps.get(lamp) + ")");
          }
        }
        if (lux >= 72 && cost < cheapest) {
          cheapest = cost;
          best = chosen;
        }
      }
      assertThat(best).as("ambient %s", ambient).containsExactly(1.0, 1.0, 0.0);
    }
  }

  private double number(String expression) {
    return facts.number((Expression.Fluent) SlParser.expression(expression)).orElseThrow();
  }

  private Truth truth(String formula) {
    return new Evaluation(facts).truth(SlParser.formula(formula, "illuminance"::equals), Map.of());
  }
}
