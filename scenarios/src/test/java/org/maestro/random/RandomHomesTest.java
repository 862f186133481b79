package org.maestro.random;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Nothing is claimed in a random home that is not so. */
class RandomHomesTest {

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void claimsNothingThatIsNotSo(long seed) {
    RandomRun run = RandomRun.withoutAgents(RandomHomes.of(seed));

    assertThat(run.agrees()).as(run.text()).isTrue();
  }

  @Test
  void tellsTheSameStoryTwiceForTheSameSeed() {
    RandomRun first = RandomRun.withoutAgents(RandomHomes.of(7));
    RandomRun second = RandomRun.withoutAgents(RandomHomes.of(7));

    assertThat(second.story()).isEqualTo(first.story());
    assertThat(second.verdicts()).isEqualTo(first.verdicts());
  }
}
