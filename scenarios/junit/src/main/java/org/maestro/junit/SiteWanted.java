package org.maestro.junit;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Optional;
import java.util.UUID;
import org.maestro.assembly.SiteSettings;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;

/** The site that a test class asked for, read from the class path. */
record SiteWanted(Class<?> testClass, MaestroTest wanted) {

  /** The site's name on the bus: another for each stage, so that all share a broker. */
  private String uniqueName() {
    return testClass.getSimpleName().toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]", "-")
        + "-"
        + UUID.randomUUID().toString().substring(0, 8);
  }

  SiteSettings settings(Optional<URI> broker) {
    String homeResource = resource("/homes/", wanted.home());
    String sceneResource = resource("/scenes/", wanted.scene());
    Home home = new HomeLoader().load(text(homeResource), homeResource);
    Scene scene =
        SceneLoader.load(
            sceneResource,
            new ByteArrayInputStream(text(sceneResource).getBytes(StandardCharsets.UTF_8)),
            home);
    return SiteSettings.of(uniqueName(), home)
        .scene(scene)
        .seed(wanted.seed())
        .broker(broker)
        .build();
  }

  private String text(String resource) {
    try (InputStream stream = testClass.getResourceAsStream(resource)) {
      if (stream == null) {
        throw new StageException(
            testClass.getSimpleName()
                + " asks for "
                + resource
                + ", which is not on its class path; name a shipped home or scene, or a .ttl"
                + " resource.");
      }
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new StageException(resource + " cannot be read: " + e.getMessage(), e);
    }
  }

  private static String resource(String folder, String name) {
    return name.endsWith(".ttl") ? name : folder + name + ".ttl";
  }
}
