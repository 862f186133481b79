package org.maestro.experiment;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;

/** Homes and scenes that are shipped for experiments. */
final class Shipped {
  private Shipped() {}

  /**
   * A home put together from several texts.
   *
   * @param additions Turtle with the first text's prefixes
   */
  static Home home(String name, String... additions) {
    String all =
        text("/homes/" + name + ".ttl")
            + Arrays.stream(additions).collect(Collectors.joining("\n", "\n", "\n"));
    return new HomeLoader().load(all, name + ".ttl");
  }

  static Scene scene(String name, Home home) {
    return SceneLoader.load(
        name,
        new ByteArrayInputStream(text("/scenes/" + name + ".ttl").getBytes(StandardCharsets.UTF_8)),
        home);
  }

  /** A scene of several homes, as far as it speaks of one of them. */
  static Scene scene(String name, Home home, List<Home> others) {
    return SceneLoader.load(name, text("/scenes/" + name + ".ttl"), home, others);
  }

  private static String text(String resource) {
    try (InputStream stream = Shipped.class.getResourceAsStream(resource)) {
      if (stream == null) {
        throw new IllegalArgumentException("There is no shipped file " + resource + ".");
      }
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException("The shipped file " + resource + " cannot be read.", e);
    }
  }
}
