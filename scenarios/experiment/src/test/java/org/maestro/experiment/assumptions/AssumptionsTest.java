package org.maestro.experiment.assumptions;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.experiment.Experiments;
import org.maestro.experiment.setting.Setting;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.parameters.PhysicalSettings;

/** The page of assumptions is what the code says, and leaves no number out. */
class AssumptionsTest {
  private static final Path PAGE = Path.of("../../docs/assumptions.md");
  private static final Path CURRENT = Path.of("target/assumptions.md");

  @Test
  void isCurrent() throws IOException {
    String page = AssumptionsPage.written();
    Files.writeString(CURRENT, page);

    assertThat(Files.readString(PAGE).lines().toList())
        .as(
            "docs/assumptions.md is not what the code says now; write it anew: cp"
                + " scenarios/experiment/target/assumptions.md docs/")
        .isEqualTo(page.lines().toList());
  }

  @Test
  void eachNumberOfTheWorldSaysWhatItIsInWhichUnitAndFromWhere() {
    assertThat(PhysicalSettings.quantities().keySet())
        .containsExactlyElementsOf(PhysicalSettings.of(PhysicalParameters.standard()).keySet());
    PhysicalSettings.quantities()
        .forEach(
            (name, quantity) ->
                assertThat(List.of(quantity.meaning(), quantity.unit(), quantity.source()))
                    .as(name)
                    .noneMatch(String::isBlank));
  }

  /** Whoever reads the page of an experiment need not look into the code. */
  @Test
  void eachExperimentNamesItsOwn() {
    assertThat(
            Experiments.named("move-object").orElseThrow().settings().stream()
                .filter(setting -> setting.name().equals("world.arm.reach"))
                .map(Setting::meaning))
        .containsExactly(
            "how far from the base's middle it grasps, m; youBot data sheet: 0.655, minus the arm's"
                + " offset and the hand's angle (assumed)");
    Experiments.all()
        .forEach(
            experiment ->
                assertThat(experiment.settings())
                    .as(experiment.name())
                    .noneMatch(setting -> setting.meaning().isBlank()));
  }
}
