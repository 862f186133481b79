package org.maestro.sim.scene;

import static java.util.Map.entry;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.home.Geometry;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.validation.Fault;

/** What in a scene is no fault, but hardly meant so: who is nowhere, and words without effect. */
final class SceneDoubts {

  /** Of what a word is said; of other things nothing comes of it. */
  private static final Map<String, Predicate<Individual>> SAID_OF =
      Map.ofEntries(
          entry("level", thing -> thing.properties().containsKey("luminousIntensity")),
          entry("strength", thing -> thing.properties().containsKey("luminousIntensity")),
          entry("opening", thing -> thing.properties().containsKey("shades")),
          entry("ambientLux", thing -> thing.classes().contains("Zone")),
          entry("celsius", thing -> thing.classes().contains("Zone")),
          entry("open", thing -> thing.classes().contains("Door")),
          entry("charges", thing -> thing.classes().contains("Location")),
          entry("charge", SceneDoubts::moves),
          entry("speed", SceneDoubts::moves),
          entry("payload", SceneDoubts::moves),
          entry("says", thing -> !thing.classes().contains("Device")),
          entry("roams", thing -> !thing.classes().contains("Device")),
          entry("walks", thing -> !thing.classes().contains("Device")));

  private final SceneText text;
  private final Scene scene;
  private final Home home;
  private final Geometry geometry;
  private final List<Fault> found = new ArrayList<>();

  SceneDoubts(SceneText text, Scene scene, Home home) {
    this.text = text;
    this.scene = scene;
    this.home = home;
    this.geometry = new Geometry(home);
  }

  private static boolean moves(Individual thing) {
    return thing.classes().contains("Device")
        && thing.classes().contains("Thing")
        && !thing.properties().containsKey("pose");
  }

  /** Robots that cannot be simulated, as nobody says where they are. */
  List<Fault> robotsNowhere() {
    return home.devices().values().stream()
        .filter(device -> device.driver().filter(driver -> driver.contains("robot")).isPresent())
        .filter(device -> scene.of(device.id()).position().isEmpty())
        .map(
            robot ->
                text.told(
                    text.line(robot.id(), "position"),
                    "does not say where %s stands; write its scene:position".formatted(robot.id())))
        .toList();
  }

  /** What is hardly meant so, by line. */
  List<Fault> found() {
    scene.entries().forEach((thing, entry) -> entry.position().ifPresent(at -> check(thing, at)));
    text.words().forEach((thing, said) -> said.keySet().forEach(word -> checkUse(thing, word)));
    found.sort(Comparator.comparing(Fault::line));
    return found;
  }

  private void check(String thing, Position at) {
    List<Polygon> floor =
        home.individuals().values().stream()
            .filter(place -> place.classes().contains("Room") || place.classes().contains("Zone"))
            .flatMap(place -> geometry.outline(place.name()).stream())
            .toList();
    Point2 point = new Point2(at.x(), at.y());
    if (!floor.isEmpty() && floor.stream().noneMatch(place -> place.contains(point))) {
      warn(
          thing,
          "position",
          "puts %s outside of every room and zone; correct its scene:position, or leave it away for what is not at home"
              .formatted(thing));
    }
  }

  private void checkUse(String thing, String word) {
    Individual said = home.individuals().get(thing);
    if (said != null && !SAID_OF.getOrDefault(word, any -> true).test(said)) {
      warn(
          thing,
          word,
          "says scene:%s of %s, and nothing comes of it; say it of what it is meant for"
              .formatted(word, thing));
    }
  }

  private void warn(String thing, String word, String sentence) {
    found.add(text.told(text.line(thing, word), sentence));
  }
}
