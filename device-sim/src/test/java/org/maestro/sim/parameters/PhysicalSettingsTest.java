package org.maestro.sim.parameters;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.sim.scene.SimulationException;

class PhysicalSettingsTest {

  private static final PhysicalParameters USUAL = PhysicalParameters.standard();

  @Test
  void everyNumberHasAName() {
    assertThat(PhysicalSettings.of(USUAL))
        .containsEntry("world.camera.noise", "0.01")
        .containsEntry("world.shutters", "true")
        .containsEntry("world.lamp.whites", "2200,2700,4000,6500")
        .containsEntry("world.camera.width", "1920")
        .hasSizeGreaterThan(50);
  }

  @Test
  void oneIsChangedAndTheOthersStay() {
    PhysicalParameters changed =
        USUAL.with(
            Map.of(
                "world.camera.noise",
                "0.05",
                "world.shutters",
                "false",
                "world.lamp.whites",
                "2700, 4000"));
    assertThat(changed.camera().noise()).isEqualTo(0.05);
    assertThat(changed.camera().frameRate()).isEqualTo(30);
    assertThat(changed.shutters()).isFalse();
    assertThat(changed.lamp().whites()).containsExactly(2700, 4000);
    assertThat(USUAL.with(Map.of())).isEqualTo(USUAL);
  }

  @Test
  void eachCanBeSetByItself() {
    PhysicalSettings.of(USUAL)
        .forEach(
            (name, value) -> {
              PhysicalParameters changed = USUAL.with(Map.of(name, other(value)));
              assertThat(PhysicalSettings.of(changed)).as(name).containsEntry(name, other(value));
              Map<String, String> rest = new TreeMap<>(PhysicalSettings.of(changed));
              rest.put(name, value);
              assertThat(rest).as(name).isEqualTo(PhysicalSettings.of(USUAL));
            });
  }

  private static String other(String value) {
    if (value.equals("true") || value.equals("false")) {
      return String.valueOf(!Boolean.parseBoolean(value));
    } else if (value.contains(",")) {
      return value.substring(0, value.indexOf(','));
    }
    return value.contains(".")
        ? String.valueOf(Double.parseDouble(value) / 2 + 0.125)
        : String.valueOf(Long.parseLong(value) + 1);
  }

  @Test
  void allCanBeWrittenAndReadAgain() {
    assertThat(USUAL.with(PhysicalSettings.of(USUAL))).isEqualTo(USUAL);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "world.camera.nois | 0.05 | There is no setting world.camera.nois; there are"
            + " world.shutters, ",
        "world.camera.noise | much | is a number from 0 on, not \"much\"",
        "world.camera.noise | -1 | is a number from 0 on",
        "world.shutters | no | is true or false",
        "world.camera.width | 2.5 | is a whole number",
        "world.base.speed | 0 | world.base.speed is more than 0",
        "world.battery.worthTelling | 3 | world.battery.worthTelling is 1 at most"
      })
  void whatMakesNoSenseIsNamed(String name, String value, String message) {
    assertThatThrownBy(() -> USUAL.with(Map.of(name, value)))
        .isInstanceOf(SimulationException.class)
        .hasMessageContaining(message);
  }

  @Test
  void readsAssignments() {
    assertThat(PhysicalSettings.parse("world.camera.noise=0.05"))
        .isEqualTo(Map.entry("world.camera.noise", "0.05"));
    assertThatThrownBy(() -> PhysicalSettings.parse("world.camera.noise"))
        .hasMessageContaining("such as world.camera.noise=0.05");
  }
}
