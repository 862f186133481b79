package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Of every experiment: the same seed gives the same tables, cell for cell, and another seed others.
 */
@Tag("full")
class SameBytesTest {

  static Stream<String> names() {
    return Experiments.all().stream().map(Experiment::name);
  }

  @ParameterizedTest
  @MethodSource("names")
  void theSameSeedGivesTheSameBytesAndAnotherOthers(String name) {
    Map<String, List<List<String>>> first = tables(name, 5);

    assertThat(tables(name, 5)).isEqualTo(first);
    Map<String, List<List<String>>> other = tables(name, 6);
    // The table of runs names its seed.
    first.remove("runs");
    other.remove("runs");
    assertThat(other).isNotEqualTo(first);
  }

  private static Map<String, List<List<String>>> tables(String name, long seed) {
    Map<String, List<List<String>>> rows = new TreeMap<>();
    CarriedOut.findings(name, 1, seed, Map.of())
        .tables()
        .forEach((table, content) -> rows.put(table, content.rows()));
    return rows;
  }
}
