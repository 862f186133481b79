package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Points by their coordinates, as names (Three-layered architecture, 1; M5). */
class PointTest {
  @ParameterizedTest
  @CsvSource({
    "(at 3.2 1.5 0.8), at_3.2_1.5_0.8",
    "(at 3.20 1.5), at_3.2_1.5_0",
    "(at -0.5 +2 1e-1), at_-0.5_2_0.1",
    "(at -0 0 0), at_0_0_0"
  })
  void standForTheSameNameHoweverTheyAreWritten(String written, String name) {
    assertThat(SlParser.term(written)).isEqualTo(new Term.Name(name));
    assertThat(Point.named(name).map(Point::name)).contains(name);
  }

  @Test
  void standWhereverATermMay() {
    assertThat(SlParser.formula("(>= (illuminance (at 3.2 1.5)) 150)"))
        .isEqualTo(SlParser.formula("(>= (illuminance at_3.2_1.5_0) 150)"));
    assertThat(SlParser.formula("(and (nextTo Cup (at 1 2)) (not (= ?p (at 1 2))))"))
        .isEqualTo(SlParser.formula("(and (nextTo Cup at_1_2_0) (not (= ?p at_1_2_0)))"));
    assertThat(SlParser.content("(initCNP (:goal (nextTo Cup (at 1 2))))"))
        .isEqualTo(SlParser.content("(initCNP (:goal (nextTo Cup at_1_2_0)))"));
    assertThat(SlParser.formula("(at \"22:30\" (nextTo Cup (at 1 2)))"))
        .isInstanceOf(Formula.Upon.class);
  }

  @ParameterizedTest
  @ValueSource(strings = {"at", "at_1_2", "at_1_2_0.0", "at_01_2_3", "at_1_2_3_4", "attic_1_2_3"})
  void otherNamesAreNone(String name) {
    assertThat(Point.named(name)).isEmpty();
  }

  @Test
  void whatIsMissingOrNoNumberIsTold() {
    assertThatThrownBy(() -> SlParser.term("(at 1)"))
        .hasMessageContaining("two or three coordinates, as in (at 3.2 1.5 0.8) was expected");
    assertThatThrownBy(() -> SlParser.formula("(nextTo Cup (at 1 x))"))
        .hasMessageContaining("At column 19 a coordinate, a number of metres, was expected");
  }
}
