package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Glass;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.floor.Segment;

class WindowsTest {
  private static final FloorPlan NOTHING = new FloorPlan(List.of(), List.of());

  /** One metre wide and from the floor to one metre, in the wall x = 0 of a room to its right. */
  private static final Glass SQUARE =
      new Glass(new Segment(new Point2(0, 0), new Point2(0, 1)), 0, 1, 1, 1, 0);

  private static final String HOME =
      """
      @prefix : <https://w3id.org/maestro/domain#> .
      @prefix home: <https://w3id.org/maestro/home/sunny#> .
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      <https://w3id.org/maestro/home/sunny> a maestro:Home ; rdfs:label "a sunny home"@en .
      home:west a maestro:Room ; maestro:outline "0 0, 4 0, 4 4, 0 4" ; maestro:height 2.5 .
      home:east a maestro:Room ; maestro:outline "4 0, 8 0, 8 4, 4 4" ; maestro:height 2.5 .
      home:south-window a maestro:Window ; rdfs:label "the south window"@en ;
        maestro:glassFrom "1 0 1" ; maestro:glassTo "3 0 2" .
      home:desk a maestro:Location ; rdfs:label "the desk"@en ; maestro:referencePoint "2 2 0.75" .
      home:shutter a :Shutter ; rdfs:label "the shutter"@en ; maestro:shades home:south-window .
      """;

  @Test
  void aPointBeforeTheCornerOfGlassGetsWhatTheTableSays() {
    // (atan(W/D) - D/sqrt(D^2+H^2) atan(W/sqrt(D^2+H^2))) / 2 pi with W = D = H = 1
    assertThat(SQUARE.factor(1, 0, 0, NOTHING)).isCloseTo(0.055734, within(1e-6));
    // W = 1, D = 2, H = 1: (0.463648 - 0.894427 * 0.420534) / 2 pi
    assertThat(SQUARE.factor(2, 0, 0, NOTHING)).isCloseTo(0.013928, within(1e-6));
  }

  @Test
  void nothingComesFromBelowOrToTheOtherSide() {
    assertThat(SQUARE.factor(1, 0, 1, NOTHING)).isZero();
    assertThat(SQUARE.factor(-1, 0, 0, NOTHING)).isZero();
    assertThat(SQUARE.factor(1, 0, 0.5, NOTHING)).isLessThan(SQUARE.factor(1, 0, 0, NOTHING));
  }

  @Test
  void aWallHidesItsPartOfTheGlass() {
    FloorPlan wall =
        new FloorPlan(List.of(Polygon.parse("0.5 0.5, 0.51 0.5, 0.51 5, 0.5 5")), List.of());
    // from (1, 0.5) the upper half of the glass lies behind the wall; both halves are alike
    assertThat(SQUARE.factor(1, 0.499, 0, wall))
        .isCloseTo(SQUARE.factor(1, 0.5, 0, NOTHING) / 2, within(0.001));
  }

  @Test
  void aShutterLetsInWhatItsWindowGivesAndTheWallsThrowBack() {
    Geometry geometry = new Geometry(new HomeLoader().load(HOME, "sunny.ttl"));
    // two squares of 1 m by 0.25 to 1.25 m above the desk, 2 m away:
    // (atan(0.5) - 2/h atan(1/h)) / 2 pi with h = sqrt(4 + 1.25^2), less the same with 0.25
    double straight = 2 * (0.019669 - 0.001058);
    // 2 m^2 of glass; 2 * 16 + 16 * 2.5 m^2 of walls that throw back one half
    double around = 2 * 0.5 / (72 * 0.5);
    assertThat(geometry.daylightShare("shutter", "desk").orElseThrow())
        .isCloseTo(0.78 * (straight + around), within(1e-5));
    assertThat(geometry.daylightShare("shutter", "east").orElseThrow()).isZero();
    assertThat(geometry.daylightShare("desk", "desk").orElseThrow()).isZero();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1 0 1 | 3 0 1 | has no breadth or no height",
        "1 1 1 | 3 1 2 | lies in no wall of a room",
        "4 1 1 | 4 2 2 | has rooms on both sides",
        "1 0 1 | 3 0 | is not understood"
      })
  void aWindowOutOfPlaceIsAFault(String from, String to, String fault) {
    String wrong =
        HOME.replace(
            "maestro:glassFrom \"1 0 1\" ; maestro:glassTo \"3 0 2\"",
            "maestro:glassFrom \"%s\" ; maestro:glassTo \"%s\"".formatted(from, to));
    assertThatThrownBy(() -> new HomeLoader().load(wrong, "sunny.ttl"))
        .isInstanceOf(HomeFaultException.class)
        .hasMessageContaining("south-window")
        .hasMessageContaining(fault);
  }

  @Test
  void aShutterBeforeNoWindowIsAFault() {
    String wrong = HOME.replace("maestro:shades home:south-window", "maestro:shades home:desk");
    assertThatThrownBy(() -> new HomeLoader().load(wrong, "sunny.ttl"))
        .isInstanceOf(HomeFaultException.class)
        .hasMessageContaining("shutter")
        .hasMessageContaining("names no window");
  }
}
