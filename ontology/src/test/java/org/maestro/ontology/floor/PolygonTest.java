package org.maestro.ontology.floor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;

class PolygonTest {

  private static final Polygon L_SHAPE = Polygon.parse("0 0, 3 0, 3 1, 1 1, 1 3, 0 3");
  private static final Polygon LEFT = Polygon.parse("0 0, 3 0, 3 3, 0 3");
  private static final Polygon RIGHT = Polygon.parse("3 0, 6 0, 6 3, 3 3");

  @Test
  void measuresAreaAndCentroid() {
    assertThat(L_SHAPE.area()).isEqualTo(5);
    assertThat(L_SHAPE.centroid().x()).isCloseTo((3 * 1.5 + 2 * 0.5) / 5, within(1e-12));
    assertThat(LEFT.centroid()).isEqualTo(new Point2(1.5, 1.5));
  }

  @Test
  void containsItsInsideAndItsEdge() {
    assertThat(L_SHAPE.contains(new Point2(0.5, 2.5))).isTrue();
    assertThat(L_SHAPE.contains(new Point2(2, 2))).isFalse();
    assertThat(L_SHAPE.contains(new Point2(3, 0.5))).isTrue();
    assertThat(L_SHAPE.contains(new Point2(1, 1))).isTrue();
    assertThat(L_SHAPE.contains(new Point2(3.01, 0.5))).isFalse();
  }

  @Test
  void samplesLieWithinAndNeverOnTheBorder() {
    Polygon upstairs = Polygon.parse("5.91 2.99, 9.16 2.99, 9.16 6.64, 5.91 6.64");

    assertThat(upstairs.samples(0.1))
        .hasSize(33 * 37)
        .allMatch(p -> upstairs.edges().stream().allMatch(edge -> edge.distance(p) > 0.04));
    assertThat(LEFT.samples(0.1)).hasSize(900);
    assertThat(LEFT.samples(10)).containsExactly(new Point2(1.5, 1.5));
  }

  @Test
  void knowsTheEdgeItSharesWithANeighbour() {
    assertThat(LEFT.sharedEdge(RIGHT)).isCloseTo(3, within(1e-9));
    assertThat(L_SHAPE.sharedEdge(RIGHT)).isCloseTo(1, within(1e-9));
    assertThat(LEFT.sharedEdge(Polygon.parse("3 3, 4 3, 4 4"))).isZero();
  }

  @Test
  void isNearWhatItsRectangleTouches() {
    assertThat(LEFT.isNear(RIGHT)).isTrue();
    assertThat(L_SHAPE.isNear(Polygon.parse("2 2, 2.5 2, 2.5 2.5"))).isTrue();
    assertThat(LEFT.isNear(Polygon.parse("3.1 0, 6 0, 6 3, 3.1 3"))).isFalse();
    assertThat(LEFT.isNear(Polygon.parse("0 -2, 3 -2, 3 -0.1"))).isFalse();
  }

  @Test
  void isEqualToOneOfTheSameCorners() {
    assertThat(Polygon.parse("0 0, 3 0, 3 3, 0 3")).isEqualTo(LEFT).hasSameHashCodeAs(LEFT);
    assertThat(RIGHT).isNotEqualTo(LEFT);
  }

  @Test
  void leavesDoorOpeningsOutOfTheWalls() {
    Segment door = new Segment(new Point2(3, 1), new Point2(3, 2));
    FloorPlan plan = new FloorPlan(List.of(LEFT, RIGHT), List.of(door));
    assertThat(plan.walls().stream().mapToDouble(Segment::length).sum())
        .isCloseTo(22, within(1e-9));
    assertThat(plan.isBlocked(new Point2(2, 1.5), new Point2(4, 1.5))).isFalse();
    assertThat(plan.isBlocked(new Point2(2, 0.5), new Point2(4, 0.5))).isTrue();
    assertThat(plan.isBlocked(new Point2(0.5, 0.5), new Point2(2.5, 2.5))).isFalse();
  }

  @Test
  void refusesWhatIsNoOutline() {
    assertThatThrownBy(() -> Polygon.parse("0 0, 1 1")).hasMessageContaining("three corners");
    assertThatThrownBy(() -> Polygon.parse("0 0, 1 x, 2 2")).hasMessageContaining("\"1 x\"");
    assertThatThrownBy(() -> Polygon.parse("0 0, 1, 2 2")).hasMessageContaining("two numbers");
    assertThatThrownBy(() -> Polygon.parse("0 0, NaN 1, 2 2")).hasMessageContaining("NaN");
  }

  @Test
  void posesLookDownUnlessTheySayOtherwise() {
    assertThat(Pose.parse("1 2 2.8").angleTo(1, 2, 0)).isCloseTo(0, within(1e-5));
    assertThat(Pose.parse("0 0 1").angleTo(1, 0, 0)).isCloseTo(45, within(1e-9));
    assertThat(Pose.parse("0 0 1 90 0 0").angleTo(0, 5, 1)).isCloseTo(0, within(1e-5));
    assertThat(Pose.parse("0 0 1 90 0 0").text()).isEqualTo("0 0 1 90 0 0");
    assertThat(Pose.parse("1 2.5 2.8").text()).isEqualTo("1 2.5 2.8");
    assertThatThrownBy(() -> Pose.parse("1 2")).hasMessageContaining("x y z yaw pitch roll");
  }
}
