package org.maestro.hal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.maestro.hal.Tsl2561.Range;

class Tsl2561Test {

  @Test
  void countsBecomeLuxByTheDataSheetsFormula() {
    // 100 lux: 3500 counts and 380 of infrared in the most sensitive range
    assertThat(Tsl2561.lux(3500, 380, Range.SENSITIVE)).isCloseTo(100, within(0.01));
    // a sixteenth of the counts at the lower gain: 1600 lux
    assertThat(Tsl2561.lux(3500, 380, Range.USUAL)).isCloseTo(1600, within(0.2));
    // more infrared, as of a glow lamp: 3500 * (0.0304 - 0.062 * 0.37893) = 24.17, calibrated by
    // 1.034
    assertThat(Tsl2561.lux(3500, 1750, Range.SENSITIVE)).isCloseTo(25.0, within(0.01));
  }

  @Test
  void staysWithinItsRange() {
    assertThat(Tsl2561.lux(0, 0, Range.SENSITIVE)).isEqualTo(0.1);
    assertThat(Tsl2561.lux(37_177, 4_036, Range.BRIGHT)).isEqualTo(40_000);
  }
}
