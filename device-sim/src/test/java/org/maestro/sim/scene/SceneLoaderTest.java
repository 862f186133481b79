package org.maestro.sim.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Home;
import org.maestro.sim.Homes;

class SceneLoaderTest {

  private static final Home BOB = Homes.home("bob");

  private static Scene load(String text) {
    String turtle = "@prefix scene: <" + SceneLoader.NAMESPACE + "> .\n" + text;
    return SceneLoader.load(
        "x.ttl", new ByteArrayInputStream(turtle.getBytes(StandardCharsets.UTF_8)), BOB);
  }

  @Test
  void readsEverythingThatASceneCanSay() {
    Scene scene =
        load(
            """
            <#Cup> scene:position "1 2 0" ; scene:hidden true ; scene:radius 0.05 ; scene:mass 0.3 .
            <#lamp-b1> scene:level 0.5 ; scene:strength 0.7 ; scene:diesWhen "adjust" .
            <#lamp-b2> scene:dead true .
            <#zone-b> scene:ambientLux 17 .
            <#door-ab> scene:open false .
            """);
    assertThat(scene.of("Cup").position()).contains(new Position(1, 2, 0));
    assertThat(scene.of("Cup").hidden()).isTrue();
    assertThat(scene.of("Cup").radius()).hasValue(0.05);
    assertThat(scene.of("Cup").mass()).hasValue(0.3);
    assertThat(scene.of("lamp-b1").level()).hasValue(0.5);
    assertThat(scene.of("lamp-b1").strength()).hasValue(0.7);
    assertThat(scene.of("lamp-b1").diesWhen()).contains(WorldEvent.Kind.ADJUST);
    assertThat(scene.of("lamp-b2").dead()).isTrue();
    assertThat(scene.of("zone-b").ambientLux()).hasValue(17);
    assertThat(scene.of("door-ab").open()).contains(false);
    assertThat(scene.of("Bob")).isEqualTo(Scene.Entry.NOTHING);
  }

  @ParameterizedTest
  @ValueSource(strings = {"bob-dark", "bob-lit", "bob-cup-in-a", "bob-hidden", "bob-weak-lamps"})
  void readsTheShippedScenes(String name) {
    assertThat(Homes.scene(name, BOB).of("rose").position()).isPresent();
  }

  @Test
  void runsTheArena() {
    try (Homes homes = new Homes("arena", "arena-dark", 1, scene -> scene)) {
      assertThat(homes.link.members()).hasSize(11);
      assertThat(homes.world().lux("zone-2")).isEqualTo(17);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<#Cupp> scene:hidden true .|speaks of Cupp",
        "<#Cup> scene:hiden true .|scene:hiden of Cup",
        "<#Cup> scene:hidden 'yes' .|it is true or false",
        "<#Cup> scene:position 'there' .|Coordinates are numbers",
        "<#Cup> scene:mass 'heavy' .|which is no number",
        "<#lamp-b1> scene:level 2 .|it lies between 0 and 1",
        "<#lamp-b1> scene:diesWhen 'sneeze' .|dies upon",
        "<#Cup> scene:position '1 2 0', '1 3 0' .|two values",
        "<#Cup> <http://x/y> 1 .|knows words of scene: only",
        "<#Cup> scene:position <#Bob> .|no literal",
        "<#Cup> scene:position|no Turtle"
      })
  void namesEveryFault(String text, String message) {
    assertThatExceptionOfType(SimulationException.class)
        .isThrownBy(() -> load(text))
        .withMessageContaining("x.ttl")
        .withMessageContaining(message);
  }
}
