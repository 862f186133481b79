package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.maestro.bench.BenchReport;
import org.maestro.bench.words.LanguageBench;

/**
 * Each figure of the language is measured, and whole sentences too where nothing is beside them.
 */
class LanguageBenchTest {

  @Test
  void allIsMeasuredAmongAFewNames() {
    BenchReport report =
        new LanguageBench(
                Shipped.text("/homes/evening.ttl").orElseThrow(),
                home -> SceneFacts.of(home, Optional.of(Shipped.scene("evening", home))),
                20,
                50,
                1,
                line -> {})
            .run();

    assertThat(report.rows()).hasSize(12).allMatch(row -> row.value() >= 0);
    assertThat(value(report, "first correct")).isBetween(10.0, 100.0);
    assertThat(value(report, "edit overhead")).isBetween(0.0, 0.5);
    assertThat(value(report, "whole sentences understood")).isGreaterThan(50.0);
    Set<Boolean> hasOther =
        report.rows().stream()
            .filter(row -> row.name().startsWith("a whole sentence"))
            .map(row -> row.baseline().isPresent())
            .collect(Collectors.toSet());
    boolean isToldMissing =
        report.summary().stream().anyMatch(line -> line.startsWith("hassil is not installed"));
    assertThat(hasOther).containsExactly(!isToldMissing);
  }

  private static double value(BenchReport report, String name) {
    return report.rows().stream()
        .filter(row -> row.name().startsWith(name))
        .findFirst()
        .orElseThrow()
        .value();
  }
}
