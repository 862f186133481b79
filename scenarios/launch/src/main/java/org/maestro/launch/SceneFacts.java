package org.maestro.launch;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sim.scene.Scene;
import org.maestro.sl.Facts;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** A home in which all that a scene says is known, as if somebody had just looked everywhere. */
final class SceneFacts {
  private static final Source SCENE = new Source(Source.Kind.OBSERVED, "scene");

  private SceneFacts() {}

  /** What is so in the home, with what the scene says. */
  static Facts of(Home home, Optional<Scene> scene) {
    try (CollectiveKnowledge knowledge = new CollectiveKnowledge(home, new SteppedClock())) {
      scene.ifPresent(there -> knowledge.state(SCENE, told(home, there)));
      return knowledge.snapshot();
    }
  }

  private static List<String> told(Home home, Scene scene) {
    List<String> facts = new ArrayList<>();
    scene
        .entries()
        .forEach(
            (name, entry) -> {
              boolean isThing =
                  Optional.ofNullable(home.individuals().get(name))
                      .filter(one -> one.classes().contains("Thing"))
                      .isPresent();
              if (isThing) {
                entry
                    .position()
                    .ifPresent(
                        place ->
                            facts.add(
                                "(position %s \"%s %s %s\")"
                                    .formatted(
                                        name,
                                        SlPrinter.print(place.x()),
                                        SlPrinter.print(place.y()),
                                        SlPrinter.print(place.z()))));
              }
              entry.open().ifPresent(open -> open(home, name, open, facts));
              entry.level().ifPresent(level -> reported(home, name, "level", level, facts));
            });
    scene.openings().forEach((name, open) -> reported(home, name, "opening", open, facts));
    // Lamps and shutters of which a scene says nothing are off and closed.
    home.devices()
        .keySet()
        .forEach(
            name -> {
              if (scene.of(name).level().isEmpty()) {
                reported(home, name, "level", 0, facts);
              }
              if (!scene.openings().containsKey(name)) {
                reported(home, name, "opening", 0, facts);
              }
            });
    home.individuals().keySet().forEach(name -> facts.addAll(scene.states(name)));
    return facts;
  }

  private static void open(Home home, String name, boolean open, List<String> facts) {
    Device device = home.devices().get(name);
    String fact = device == null ? null : device.reports().get("open");
    if (fact != null) {
      String atom = fact.replace("?self", name);
      facts.add(open ? atom : "(not " + atom + ")");
    }
  }

  /** What the device would report of itself. */
  private static void reported(
      Home home, String name, String word, double value, List<String> facts) {
    Device device = home.devices().get(name);
    String fact = device == null ? null : device.reports().get(word);
    if (fact != null) {
      facts.add(
          fact.replace("?self", name).replace("?" + word, SlPrinter.print(new Term.Number(value))));
    }
  }
}
