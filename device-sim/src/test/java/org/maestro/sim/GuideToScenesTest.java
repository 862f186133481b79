package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.ontology.home.Home;
import org.maestro.sim.scene.Deed;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;

/** Each example of the guide is read, and lived through for five minutes. */
class GuideToScenesTest {

  private static final Home BOB = Homes.home("bob");

  private static String guide() throws IOException {
    return Files.readString(Path.of("../docs/guide-scenes.md"));
  }

  static List<String> examples() throws IOException {
    return Pattern.compile("```turtle\n(.*?)```", Pattern.DOTALL)
        .matcher(guide())
        .results()
        .map(match -> match.group(1))
        .toList();
  }

  @ParameterizedTest
  @MethodSource("examples")
  void runs(String example) {
    Scene scene =
        SceneLoader.load(
            "guide", new ByteArrayInputStream(example.getBytes(StandardCharsets.UTF_8)), BOB);
    try (Homes homes = new Homes(BOB, scene, 1)) {
      homes.clock.run(Duration.ofMinutes(5));
      assertThat(homes.world().bodies()).contains("rose");
    }
  }

  @Test
  void namesEveryFault() throws IOException {
    String guide = guide();
    for (Deed deed : Deed.values()) {
      assertThat(guide).contains("`" + deed.name().toLowerCase(Locale.ROOT));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"<#Bob>", "<>"})
  void namesEveryWord(String subject) throws IOException {
    String scene =
        """
        @base <https://w3id.org/maestro/home/bob> .
        @prefix scene: <https://w3id.org/maestro/scene#> .
        <> scene:latitude 49 ; scene:dayOfYear 81 ; scene:solarTime "09:30" .
        %s scene:xxxxxxxx 1 .
        """
            .formatted(subject);
    ByteArrayInputStream text = new ByteArrayInputStream(scene.getBytes(StandardCharsets.UTF_8));
    String refused = catchThrowable(() -> SceneLoader.load("words", text, BOB)).getMessage();
    String known = refused.substring(refused.indexOf("known are ") + "known are ".length());

    assertThat(known.replace(".", "").split(", "))
        .hasSizeGreaterThan(5)
        .allSatisfy(word -> assertThat(guide()).contains("`" + word + "`"));
  }
}
