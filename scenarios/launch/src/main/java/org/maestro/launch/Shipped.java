package org.maestro.launch;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.maestro.language.Language;
import org.maestro.language.grammar.GrammarFaultException;
import org.maestro.ontology.home.CheckedHome;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.CheckedScene;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;

/** Homes and scenes by the name of a shipped one, or by a file's path. */
final class Shipped {
  static final List<String> HOMES =
      List.of("bob", "arena", "housekeeper", "evening", "rooms", "people", "exploration");
  static final List<String> SCENES =
      List.of(
          "bob-dark",
          "bob-lit",
          "bob-cup-in-a",
          "bob-hidden",
          "bob-weak-lamps",
          "arena-dark",
          "housekeeper",
          "evening",
          "homecoming",
          "glasses",
          "rooms",
          "people",
          "exploration");

  private Shipped() {}

  /** The names of the homes, for shells that complete them. */
  static final class Homes implements Iterable<String> {
    @Override
    public Iterator<String> iterator() {
      return HOMES.iterator();
    }
  }

  /** The names of the scenes, for shells that complete them. */
  static final class Scenes implements Iterable<String> {
    @Override
    public Iterator<String> iterator() {
      return SCENES.iterator();
    }
  }

  /** Whether this can be meant as a home, and as no other file. */
  static boolean isHome(String nameOrPath) {
    return HOMES.contains(nameOrPath) || nameOrPath.endsWith(".ttl");
  }

  /** Whether a shipped home is meant, and no file. */
  static boolean isShipped(String nameOrPath) {
    return text("/homes/" + nameOrPath + ".ttl").isPresent();
  }

  static Home home(String nameOrPath) {
    Optional<String> shipped = text("/homes/" + nameOrPath + ".ttl");
    if (shipped.isPresent()) {
      return new HomeLoader().load(shipped.get(), nameOrPath + ".ttl");
    }
    return understood(new HomeLoader().load(file(nameOrPath, "home", HOMES)));
  }

  /** A home whose own grammars can be read. */
  private static Home understood(Home home) {
    try {
      Language.check(home);
      return home;
    } catch (GrammarFaultException e) {
      throw CommandException.badInput(String.valueOf(e.getMessage()));
    }
  }

  /** A home with what is to be said of it. */
  static CheckedHome checkedHome(String nameOrPath) {
    return text("/homes/" + nameOrPath + ".ttl")
        .map(shipped -> new HomeLoader().check(shipped, nameOrPath + ".ttl"))
        .orElseGet(
            () -> {
              CheckedHome checked = new HomeLoader().check(file(nameOrPath, "home", HOMES));
              understood(checked.home());
              return checked;
            });
  }

  static Scene scene(String nameOrPath, Home home) {
    return scene(nameOrPath, home, List.of());
  }

  /** A scene of several homes, as far as it speaks of one of them. */
  static Scene scene(String nameOrPath, Home home, List<Home> all) {
    String text =
        text("/scenes/" + nameOrPath + ".ttl")
            .orElseGet(() -> read(file(nameOrPath, "scene", SCENES)));
    return SceneLoader.load(nameOrPath, text, home, all);
  }

  /** What is to be said of a scene. */
  static CheckedScene checkedScene(String nameOrPath, Home home) {
    return text("/scenes/" + nameOrPath + ".ttl")
        .map(shipped -> SceneLoader.check(nameOrPath + ".ttl", shipped, home))
        .orElseGet(
            () -> {
              Path file = file(nameOrPath, "scene", SCENES);
              return SceneLoader.check(String.valueOf(file.getFileName()), read(file), home);
            });
  }

  /** The scene that goes with a shipped home when none is named. */
  static Optional<String> usualScene(String home) {
    return Stream.of(home, home + "-dark").filter(SCENES::contains).findFirst();
  }

  /** The text in front of a shipped scene that tells people what it is. */
  static String introduction(String scene) {
    return text("/scenes/" + scene + ".ttl")
        .map(text -> text.lines().takeWhile(line -> line.startsWith("#")))
        .map(lines -> String.join(" ", lines.map(line -> line.substring(1).strip()).toList()))
        .orElse("");
  }

  /**
   * A file that is there.
   *
   * @param shipped names that may stand in its place
   */
  static Path file(String path, String what, List<String> shipped) {
    Path file = Path.of(path);
    if (!Files.isRegularFile(file) && shipped.isEmpty()) {
      throw CommandException.badInput(
          "There is no file %s; give the path of a %s.".formatted(path, what));
    }
    if (!Files.isRegularFile(file)) {
      throw CommandException.badInput(
          "There is no %s file %s; give the path of a Turtle file, or one of the shipped %ss: %s."
              .formatted(what, path, what, String.join(", ", shipped)));
    }
    return file;
  }

  static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw CommandException.outside("The file " + file + " cannot be read.", e);
    }
  }

  static Optional<String> text(String resource) {
    try (InputStream stream = Shipped.class.getResourceAsStream(resource)) {
      return stream == null
          ? Optional.empty()
          : Optional.of(new String(stream.readAllBytes(), StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw CommandException.outside("The shipped file " + resource + " cannot be read.", e);
    }
  }
}
