package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.maestro.fixtures.Share;

/** The evening with which ADE begins, whatever chance makes of sensors and ways (A1 to A6). */
@Tag("full")
class HundredEveningsTest {
  @TempDir Path stories;

  static LongStream seeds() {
    return Share.of(LongStream.rangeClosed(1, 100));
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void allIsAsItIsToBe(long seed) {
    FamilyEvening evening = new FamilyEvening(seed % 2 == 0, seed, Optional.empty());

    evening.run(stories);

    assertThat(evening.amiss()).isEmpty();
  }
}
