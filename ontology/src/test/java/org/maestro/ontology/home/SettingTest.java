package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.sl.Term;

/** What a setting can be set to. */
class SettingTest {

  private static Setting setting(double lowest, double highest, double grain) {
    return new Setting(
        "level",
        OptionalDouble.of(lowest),
        OptionalDouble.of(highest),
        OptionalDouble.of(grain),
        Optional.empty(),
        0,
        false);
  }

  @Test
  void itsValuesAreThoseThatPeopleWrite() {
    assertThat(setting(0, 1, 0.1).values())
        .extracting(value -> ((Term.Number) value).value())
        .containsExactly(0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0);
  }

  @Test
  void theHighestIsLeftOutThatNoStepReaches() {
    assertThat(setting(5, 30, 10).values())
        .extracting(value -> ((Term.Number) value).value())
        .containsExactly(5.0, 15.0, 25.0);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "19.5 | ",
        "4.5 | lies between 5 and 30, and is not 4.5",
        "31 | lies between 5 and 30, and is not 31",
        "19.2 | goes in steps of 0.5, and 19.2 is none"
      })
  void whatItCannotBeSetToIsSaid(double value, String reason) {
    assertThat(setting(5, 30, 0.5).refusal(new Term.Number(value)))
        .isEqualTo(Optional.ofNullable(reason));
  }

  @Test
  void oneWithoutNumbersTakesAnything() {
    Setting source =
        new Setting(
            "source",
            OptionalDouble.empty(),
            OptionalDouble.empty(),
            OptionalDouble.empty(),
            Optional.empty(),
            0,
            true);

    assertThat(source.refusal(new Term.Name("satellite"))).isEmpty();
    assertThat(source.values()).isEmpty();
    assertThat(setting(0, 9, 1).refusal(new Term.Name("satellite")))
        .contains("is a number, not satellite");
  }
}
