package org.maestro.sl;

import java.util.List;

/** Points by their coordinates, {@code (at 3.2 1.5 0.8)}, or {@code (at 3.2 1.5)} on the floor. */
final class PointSyntax {
  private static final String EXPECTED = "two or three coordinates, as in (at 3.2 1.5 0.8)";
  private static final int ON_THE_FLOOR = 2;
  private static final int IN_SPACE = 3;

  private PointSyntax() {}

  /** Whether a node is meant as a point: a time begins with the same word, and a text. */
  static boolean begins(Node node) {
    return node instanceof Node.Group group
        && group.head().equals(Point.WORD)
        && !group.rest().isEmpty()
        && isNumber(group.rest().get(0));
  }

  /** The name that stands for the point. */
  static Term.Name name(Node node) {
    List<Node> coordinates = ((Node.Group) node).rest();
    for (Node coordinate : coordinates) {
      if (!isNumber(coordinate)) {
        throw coordinate.fault("a coordinate, a number of metres,");
      }
    }
    if (coordinates.size() != ON_THE_FLOOR && coordinates.size() != IN_SPACE) {
      throw node.fault(EXPECTED);
    }
    double z = coordinates.size() == IN_SPACE ? number(coordinates.get(2)) : 0;
    return new Term.Name(
        new Point(number(coordinates.get(0)), number(coordinates.get(1)), z).name());
  }

  private static boolean isNumber(Node node) {
    return node instanceof Node.Leaf leaf && leaf.kind() == Node.Kind.NUMBER;
  }

  private static double number(Node node) {
    return Double.parseDouble(((Node.Leaf) node).text());
  }
}
