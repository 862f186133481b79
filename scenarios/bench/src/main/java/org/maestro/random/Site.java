package org.maestro.random;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sim.scene.Scene;
import org.maestro.sl.Term;

/** The fixed part of a home, as the judge sees it. */
final class Site {
  static final double CAMERA_LEAST_LUX = 72;
  static final double CAMERA_GREATEST_LUX = 2000;

  private final Home home;
  private final Scene scene;
  private final Floor floor;
  private final Map<String, Double> strengths = new TreeMap<>();

  Site(Home home, Scene scene) {
    this.home = home;
    this.scene = scene;
    this.floor = new Floor(this);
    lamps().forEach(lamp -> strengths.put(lamp, scene.of(lamp).strength().orElse(1)));
  }

  Floor floor() {
    return floor;
  }

  Home home() {
    return home;
  }

  List<String> devices() {
    return List.copyOf(home.devices().keySet());
  }

  List<String> cameras() {
    return of("Camera");
  }

  List<String> lamps() {
    return of("Lamp");
  }

  List<String> shutters() {
    return of("Shutter");
  }

  /** A step behind the glass before which the shutter hangs. */
  Point2 insideOfWindow(String shutter) {
    String window =
        values(shutter, "shades").stream()
            .filter(Term.Name.class::isInstance)
            .map(term -> ((Term.Name) term).text())
            .findFirst()
            .orElseThrow();
    Position from = position(window, "glassFrom");
    Position to = position(window, "glassTo");
    return new Point2((from.x() + to.x()) / 2, (from.y() + to.y()) / 2 + 0.1);
  }

  List<String> robots() {
    return of("MobileRobot");
  }

  List<String> persons() {
    return of("Person");
  }

  /** Whether persons go about in it of their own accord. */
  boolean isInhabited() {
    return !scene.course().roams().isEmpty();
  }

  List<String> items() {
    return of("Item");
  }

  List<String> of(String className) {
    return home.individuals().values().stream()
        .filter(individual -> individual.classes().contains(className))
        .map(Individual::name)
        .toList();
  }

  double strength(String lamp) {
    return Objects.requireNonNull(strengths.get(lamp));
  }

  void weakened(String lamp, double strength) {
    strengths.put(lamp, strength);
  }

  double ambient(String zone) {
    return scene.of(zone).ambientLux().orElse(0);
  }

  double radius(String body) {
    return robots().contains(body) ? 0.347 : scene.of(body).radius().orElse(0.04);
  }

  double payload(String robot) {
    return number(robot, "payload");
  }

  double mass(String item) {
    return scene.of(item).mass().orElse(0.25);
  }

  boolean isTrue(String name, String property) {
    return values(name, property).contains(new Term.Truth(true));
  }

  double number(String name, String property) {
    OptionalDouble number =
        values(name, property).stream()
            .filter(Term.Number.class::isInstance)
            .mapToDouble(term -> ((Term.Number) term).value())
            .findFirst();
    return number.orElseThrow(() -> new IllegalArgumentException(name + " has no " + property));
  }

  Pose pose(String name) {
    return Pose.parse(text(name, "pose"));
  }

  Position position(String name, String property) {
    String[] numbers = text(name, property).split(" ");
    return new Position(
        Double.parseDouble(numbers[0]),
        Double.parseDouble(numbers[1]),
        Double.parseDouble(numbers[2]));
  }

  Point2 point(String name, String property) {
    String[] numbers = text(name, property).split(" ");
    return new Point2(Double.parseDouble(numbers[0]), Double.parseDouble(numbers[1]));
  }

  String text(String name, String property) {
    return values(name, property).stream()
        .filter(Term.Text.class::isInstance)
        .map(term -> ((Term.Text) term).value())
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(name + " has no " + property));
  }

  private List<Term> values(String name, String property) {
    Individual individual = Objects.requireNonNull(home.individuals().get(name));
    return individual.properties().getOrDefault(property, List.of());
  }
}
