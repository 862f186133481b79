package org.maestro.guide;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.home.Home;

/** Whoever describes a device finds every key that a feature may have in the guide. */
class KeysOfDescriptionsTest {

  /** Prefixes, what is said of things and places, and what stands in the guide to homes. */
  private static final Set<String> OF_OTHERS =
      Set.of(
          "maestro",
          "domain",
          "owl",
          "rdfs",
          "xsd",
          "comment",
          "likelyWhen",
          "driver",
          "container",
          "hostNeeds",
          "order",
          "pursues",
          "benefit",
          "allowed",
          "pose",
          "position",
          "viewAngle",
          "frameRate",
          "resolution",
          "luminousIntensity",
          "beamAngle",
          "outline",
          "height",
          "referencePoint");

  @Test
  void standInTheGuide() throws IOException {
    String guide = Files.readString(Path.of("../../docs/guide-bus.md"));
    List<String> keys = new ArrayList<>();
    try (InputStream context =
        Home.class.getResourceAsStream("/org/maestro/ontology/context.jsonld")) {
      new ObjectMapper()
          .readTree(context)
          .path("@context")
          .fieldNames()
          .forEachRemaining(keys::add);
    }
    keys.removeIf(key -> key.startsWith("@") || OF_OTHERS.contains(key));

    assertThat(keys)
        .hasSizeGreaterThan(40)
        .allMatch(
            key ->
                guide.contains("`" + key + "`")
                    || guide.contains("\"" + key + "\":")
                    || guide.contains("maestro:" + key));
  }
}
