package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Glass;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.floor.Segment;
import org.maestro.sl.Term;

/**
 * The windows of a home, and how much of the light upon them comes to a point: straight from the
 * glass ({@link Glass#factor}), and from the walls of the room, which throw it to and fro until it
 * is everywhere the same (the internally reflected part of the split-flux method; Hopkinson,
 * Petherbridge and Longmore, "Daylighting", 1966). Doors are counted as wall. Immutable.
 */
public final class Windows {

  /** Mean reflectance of all surfaces of a furnished room; assumed, as in that method's tables. */
  private static final double REFLECTANCE = 0.5;

  /** Of a room that does not state its height; metres, assumed. */
  private static final double USUAL_HEIGHT = 2.5;

  private static final double ASIDE_METRES = 0.05;

  private final Map<String, Window> windows = new LinkedHashMap<>();
  private final Map<String, List<String>> shadedBy = new TreeMap<>();

  /**
   * A window with its room.
   *
   * @param reflected light at every point of the room that comes from its walls, as a share of the
   *     light that comes through each part of the glass
   */
  public record Window(String name, Glass glass, Polygon room, double reflected) {

    /**
     * Lux at a point for each lux that falls diffusely upon the outside of the glass.
     *
     * @param plan the walls that stand between
     */
    public double share(double x, double y, double z, FloorPlan plan) {
      return glass.transmittance() * glass.factor(x, y, z, plan) + reflectedShare(new Point2(x, y));
    }

    /** The part of it that comes from the room's walls. */
    public double reflectedShare(Point2 point) {
      return room.contains(point) ? glass.transmittance() * reflected : 0;
    }
  }

  /**
   * @param home its windows stand in outer walls, as the loader makes sure
   */
  public Windows(Home home) {
    for (Individual individual : home.individuals().values()) {
      if (individual.classes().contains("Window")) {
        window(individual, home).ifPresent(window -> windows.put(window.name(), window));
      }
      for (Term shaded : individual.properties().getOrDefault("shades", List.of())) {
        if (shaded instanceof Term.Name window) {
          shadedBy.computeIfAbsent(individual.name(), none -> new ArrayList<>()).add(window.text());
        }
      }
    }
  }

  /** By name. */
  public Map<String, Window> all() {
    return Collections.unmodifiableMap(windows);
  }

  /** The windows before which a device hangs. */
  public List<Window> shadedBy(String device) {
    return shadedBy.getOrDefault(device, List.of()).stream()
        .filter(windows::containsKey)
        .map(windows::get)
        .toList();
  }

  /** Lux at a point for each lux upon the windows that the device shades, opened wholly. */
  double share(String device, double x, double y, double z, FloorPlan plan) {
    return shadedBy(device).stream().mapToDouble(window -> window.share(x, y, z, plan)).sum();
  }

  /** The part of it that comes from the room's walls. */
  double reflectedShare(String device, Point2 point) {
    return shadedBy(device).stream().mapToDouble(window -> window.reflectedShare(point)).sum();
  }

  /** What is wrong with the place of a window, if anything is. */
  static Optional<String> misplacement(Individual individual, Home home) {
    double[] from = corner(individual, "glassFrom");
    double[] to = corner(individual, "glassTo");
    Segment base = new Segment(new Point2(from[0], from[1]), new Point2(to[0], to[1]));
    if (base.length() <= Segment.TOLERANCE || to[2] <= from[2]) {
      return Optional.of("has no breadth or no height");
    }
    boolean inWall =
        rooms(home).stream()
            .flatMap(room -> outline(room).edges().stream())
            .anyMatch(edge -> edge.covers(base));
    if (!inWall) {
      return Optional.of("lies in no wall of a room");
    }
    return window(individual, home).isPresent()
        ? Optional.empty()
        : Optional.of("has rooms on both sides");
  }

  private static Optional<Window> window(Individual individual, Home home) {
    double[] from = corner(individual, "glassFrom");
    double[] to = corner(individual, "glassTo");
    Segment base = new Segment(new Point2(from[0], from[1]), new Point2(to[0], to[1]));
    double acrossX = -(to[1] - from[1]) / base.length();
    double acrossY = (to[0] - from[0]) / base.length();
    Optional<Individual> left = roomAt(home, beside(base, acrossX, acrossY));
    Optional<Individual> right = roomAt(home, beside(base, -acrossX, -acrossY));
    if (left.isPresent() == right.isPresent()) {
      return Optional.empty();
    }
    double sign = left.isPresent() ? 1 : -1;
    double transmittance = number(individual, "transmittance").orElse(Glass.USUAL_TRANSMITTANCE);
    Glass glass = new Glass(base, from[2], to[2], transmittance, sign * acrossX, sign * acrossY);
    Individual room = left.or(() -> right).orElseThrow();
    return Optional.of(new Window(individual.name(), glass, outline(room), reflected(glass, room)));
  }

  /** What enters, thrown about by all surfaces of the room: its area times R / (A (1 - R)). */
  private static double reflected(Glass glass, Individual room) {
    Polygon outline = outline(room);
    double around = outline.edges().stream().mapToDouble(Segment::length).sum();
    double surfaces = 2 * outline.area() + around * number(room, "height").orElse(USUAL_HEIGHT);
    return glass.area() * REFLECTANCE / (surfaces * (1 - REFLECTANCE));
  }

  private static Point2 beside(Segment base, double acrossX, double acrossY) {
    return base.middle().plus(ASIDE_METRES * acrossX, ASIDE_METRES * acrossY);
  }

  private static Optional<Individual> roomAt(Home home, Point2 point) {
    return rooms(home).stream().filter(room -> outline(room).contains(point)).findFirst();
  }

  private static List<Individual> rooms(Home home) {
    return home.individuals().values().stream()
        .filter(individual -> individual.classes().contains("Room"))
        .toList();
  }

  private static Polygon outline(Individual room) {
    return Polygon.parse(text(room, "outline"));
  }

  private static double[] corner(Individual window, String property) {
    return Glass.corner(text(window, property));
  }

  private static String text(Individual individual, String property) {
    return individual.properties().getOrDefault(property, List.of()).stream()
        .filter(Term.Text.class::isInstance)
        .map(term -> ((Term.Text) term).value())
        .findFirst()
        .orElseThrow(
            () -> new IllegalArgumentException(individual.name() + " has no " + property + "."));
  }

  private static Optional<Double> number(Individual individual, String property) {
    return individual.properties().getOrDefault(property, List.of()).stream()
        .filter(Term.Number.class::isInstance)
        .map(term -> ((Term.Number) term).value())
        .findFirst();
  }
}
