package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.experiment.drawing.Figure;

/** One run each way; the first run is the same however many there are. */
class MoveObjectTest {
  private static final Map<String, String> COVERED_SKY =
      Map.of("world.clouds", "1", "world.clouds.change", "0");

  @TempDir private Path directory;

  @Test
  void theSameSeedGivesTheSameBytesAndAnotherOthers() throws IOException {
    Findings findings = CarriedOut.findings("move-object", 2, 7, COVERED_SKY);
    findings.write(directory.resolve("first"));
    CarriedOut.findings("move-object", 1, 7, COVERED_SKY).write(directory.resolve("again"));
    CarriedOut.findings("move-object", 1, 8, COVERED_SKY).write(directory.resolve("other"));

    for (String table : List.of("runs", "details", "trail", "story")) {
      String first = content("first", table);
      assertThat(first).startsWith(content("again", table));
      assertThat(first).doesNotStartWith(content("other", table));
    }
    assertThat(directory.resolve("first").resolve("index.html")).isNotEmptyFile();
    assertThat(directory.resolve("first").resolve("execution-time.png")).isNotEmptyFile();
    CarriedOut.assertReadable(findings);
    assertThat(findings.figures())
        .extracting(Figure::name)
        .contains("execution-time", "heat-green-to-red", "heat-red-to-green");
    assertThat(findings.results())
        .extracting(Findings.Result::name)
        .contains("time of a run that was reached, mean");
    assertThat(findings.page().html())
        .contains("0.8 m/s, which is the youBot's data sheet")
        .as("mean and deviation")
        .containsPattern("<td>time of a run</td><td>[^<]*</td><td>\\d+\\.\\d s ± \\d+\\.\\d s ");
    assertThat(findings.tables().get("runs").columns())
        .containsExactly(
            "run", "seed", "goal", "success", "duration_s", "lower_bound_s", "replans", "failure");
    assertThat(findings.tables().get("runs").rows())
        .extracting(row -> row.get(2), row -> row.get(3))
        .containsExactly(
            tuple("(nextTo GreenObject RedObject1)", "true"),
            tuple("(nextTo RedObject1 GreenObject)", "true"));
  }

  @Test
  void isReachedAsWellWhereCamerasFindThingsInTheirPictures() throws IOException {
    Findings findings =
        CarriedOut.findings("move-object", 1, 1, Map.of("world.camera.fromPixels", "true"));

    assertThat(findings.tables().get("runs").rows())
        .extracting(row -> row.get(3))
        .containsExactly("true");
  }

  private String content(String run, String table) throws IOException {
    return Files.readString(directory.resolve(run).resolve(table + ".csv"));
  }
}
