package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.maestro.experiment.setting.Setting;
import org.maestro.fixtures.Share;

/** Whatever can be set in an experiment changes what a run of it writes. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class SettingsActTest {

  /** Acts with {@code --paced} alone. */
  private static final String PACED = "paced.speed";

  private final Map<String, List<Object>> usual = new TreeMap<>();

  static Stream<Arguments> settings() {
    List<Arguments> all =
        Stream.of("move-object", "illumination", "join-leave", "broken-cup")
            .flatMap(
                experiment ->
                    names(experiment).stream()
                        .filter(name -> !name.equals(PACED))
                        .map(name -> Arguments.of(experiment, name)))
            .toList();
    return Share.of(LongStream.range(0, all.size())).mapToObj(number -> all.get((int) number));
  }

  private static Set<String> names(String experiment) {
    return Experiments.named(experiment).orElseThrow().settings().stream()
        .map(Setting::name)
        .collect(Collectors.toCollection(LinkedHashSet::new));
  }

  @Tag("full")
  @ParameterizedTest(name = "{0} {1}")
  @MethodSource("settings")
  void eachChangesWhatIsWritten(String experiment, String name) {
    TellingRun run = TellingRun.of(experiment, name);
    List<Object> before =
        usual.computeIfAbsent(experiment + run.kind() + run.given(), any -> run.written());

    assertThat(run.changed().written().equals(before))
        .as("nothing changes: %s", run.changed())
        .isFalse();
  }

  /** It carries out the runs of move-object, under conditions that it sets by itself. */
  @Test
  void overExposureOffersWhatMoveObjectDoes() {
    Set<String> expected = names("move-object");
    expected.removeAll(Set.of(PACED, "world.shutters", "world.camera.noticesGlare"));
    assertThat(names("over-exposure")).isEqualTo(expected);
  }

  @Test
  void whatActsElsewhereIsSaid() {
    assertThat(notes("illumination", "world.facade.noise"))
        .containsExactly(
            "world.facade.noise changes nothing in illumination; it acts in move-object,"
                + " over-exposure, setups.");
    assertThat(notes("join-leave", "world.turn.height"))
        .containsExactly("world.turn.height changes nothing in join-leave; it acts in setups.");
    assertThat(notes("move-object", "world.facade.noise")).isEmpty();
  }

  private static List<String> notes(String experiment, String name) {
    return Experiments.settings(Experiments.named(experiment).orElseThrow(), Map.of(name, "1"))
        .notes();
  }
}
