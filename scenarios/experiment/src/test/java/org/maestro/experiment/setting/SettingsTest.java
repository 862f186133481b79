package org.maestro.experiment.setting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class SettingsTest {
  private static final List<Setting> KNOWN =
      List.of(
          Setting.number("speed", 0.8, 0.1, 5, "metres a second"),
          Setting.truth("shutters", true, "whether there are any"));
  private static final List<Setting> GROUPED =
      List.of(
          Setting.number("world.camera.noise", 0.01, 0, 1, "metres a metre"),
          Setting.number("world.sensor.noise", 0.03, 0, 1, "relative"),
          Setting.number("world.sensor.least", 0.1, 0, 1, "lux"));

  @Test
  void whatIsNotGivenIsAsUsual() {
    Settings settings = new Settings(KNOWN, Map.of("speed", "0.2"));

    assertThat(settings.number("speed")).isEqualTo(0.2);
    assertThat(settings.truth("shutters")).isTrue();
  }

  @Test
  void whatMakesNoSenseIsRefusedInASentence() {
    refused(
        Map.of("sped", "1"), "Nothing here is called sped; what can be set is speed, shutters.");
    refused(Map.of("speed", "fast"), "speed is a number, not \"fast\".");
    refused(Map.of("speed", "NaN"), "speed lies between 0.1 and 5, not at NaN.");
    refused(Map.of("speed", "9"), "speed lies between 0.1 and 5, not at 9.");
    refused(Map.of("shutters", "yes"), "shutters is true or false, not \"yes\".");
  }

  @Test
  void halfANameIsCompleted() {
    assertThatThrownBy(() -> new Settings(GROUPED, Map.of("camera.noise", "0")))
        .hasMessageEndingWith("what can be set is world.camera.noise.");
    assertThatThrownBy(() -> new Settings(GROUPED, Map.of("world.sensor.noice", "0")))
        .hasMessageEndingWith("what can be set is world.sensor.noise, world.sensor.least.");
  }

  private static void refused(Map<String, String> given, String sentence) {
    assertThatThrownBy(() -> new Settings(KNOWN, given))
        .isInstanceOf(SettingException.class)
        .hasMessage(sentence);
  }
}
