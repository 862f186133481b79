package org.maestro.scenario;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import org.maestro.assembly.PastDays;
import org.maestro.assembly.SiteSettings;
import org.maestro.coordination.api.Speech;
import org.maestro.hal.Position;
import org.maestro.hal.Settings;
import org.maestro.hal.Switch;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** The family's house on an evening, with days behind it, and all that is said in it. */
final class EveningStage implements AutoCloseable {
  private static final Map<String, Position> MIDDLES =
      Map.of(
          "kitchen", new Position(7, 3.2, 0),
          "livingroom", new Position(1.4, 2.4, 0),
          "hallway", new Position(5.2, 4.75, 0),
          "bathroom", new Position(10.6, 1, 0),
          "bedroom", new Position(3.6, 7.8, 0),
          "garden", new Position(-1.5, 4.75, 0));

  private final Stage stage;
  private final List<Said> said = new CopyOnWriteArrayList<>();
  private final List<String> told = new CopyOnWriteArrayList<>();

  /** A sentence, to whom or in which room, and when. */
  record Said(String to, String text, Duration at) {}

  private EveningStage(Stage stage) {
    this.stage = stage;
    stage.platform().desk().whenSaid(this::hear);
    stage.platform().onStory(entry -> told.add(entry.goalId() + " " + entry.text()));
  }

  private void hear(Speech speech) {
    said.add(new Said(speech.to(), speech.text(), stage.clock().now()));
  }

  /** The scene with more lines of Turtle. */
  static EveningStage of(Path data, PastDays past, String scene, String... more) {
    past.keepIn(data, new SteppedClock().start());
    Home home = new HomeLoader().load(text("/homes/evening.ttl"), "evening.ttl");
    String turtle = text("/scenes/" + scene + ".ttl") + String.join("\n", more);
    return new EveningStage(
        Stage.stepped(
            SiteSettings.of("evening-" + UUID.randomUUID(), home)
                .scene(
                    SceneLoader.load(
                        scene,
                        new ByteArrayInputStream(turtle.getBytes(StandardCharsets.UTF_8)),
                        home))
                .dataDirectory(data)
                .build()));
  }

  static String text(String resource) {
    try (InputStream stream = PastDays.class.getResourceAsStream(resource)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  Stage stage() {
    return stage;
  }

  void put(String person, String room) {
    stage.world().moveByHand(person, MIDDLES.get(room));
  }

  /** All that was said in these words. */
  List<Said> said(String text) {
    return said.stream().filter(one -> one.text().equals(text)).toList();
  }

  /** Whether the story of any goal has told something in which these words stand. */
  boolean isTold(String words) {
    return told.stream().anyMatch(one -> one.contains(words));
  }

  List<String> told() {
    return List.copyOf(told);
  }

  List<Said> said() {
    return List.copyOf(said);
  }

  void awaitSaid(String text) {
    stage.await("it is said: " + text, () -> !said(text).isEmpty());
  }

  boolean isOn(String device) {
    return stage.drivers(device).find(Switch.class).orElseThrow().isOn();
  }

  /** What the device is truly set to; "" where it is not set. */
  String setting(String device, String name) {
    Term value = stage.drivers(device).find(Settings.class).orElseThrow().values().get(name);
    return value == null ? "" : SlPrinter.print(value);
  }

  @Override
  public void close() {
    stage.close();
  }
}
