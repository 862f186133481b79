package org.maestro.random;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.LongStream;
import org.assertj.core.api.SoftAssertions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Nothing is claimed in a random home that is not so. A failing seed is seen again with {@code
 * -Dmaestro.seed=N}, which then is the only one.
 */
class RandomHomesTest {
  private static final String SEED = "maestro.seed";

  /** A hundredth of all, of those that take no long planning, or the one that is asked for. */
  static LongStream someSeeds() {
    return Long.getLong(SEED) == null
        ? LongStream.rangeClosed(3, 23).filter(seed -> seed != 12)
        : seeds(1);
  }

  private static LongStream seeds(int count) {
    Long one = Long.getLong(SEED);
    return one == null ? LongStream.rangeClosed(1, count) : LongStream.of(one);
  }

  @ParameterizedTest(name = "seed {0}")
  @MethodSource("someSeeds")
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

  @Test
  @Tag("full")
  void claimsNothingThatIsNotSoInTwoThousandHomes() {
    Map<Verdict.Kind, Integer> counts = new EnumMap<>(Verdict.Kind.class);
    SoftAssertions softly = new SoftAssertions();
    seeds(2_000)
        .forEach(
            seed -> {
              RandomRun run = RandomRun.withoutAgents(RandomHomes.of(seed));
              run.verdicts().forEach(verdict -> counts.merge(verdict.kind(), 1, Integer::sum));
              softly.assertThat(run.agrees()).as(run.text()).isTrue();
            });
    softly.assertThat(counts).as("both ends are met").containsKey(Verdict.Kind.ACHIEVED);
    softly.assertThat(counts).containsKey(Verdict.Kind.IMPOSSIBLE);
    softly.assertAll();
  }

  @Test
  @Tag("full")
  void agentsClaimTheSameInAHundredHomes() {
    SoftAssertions softly = new SoftAssertions();
    seeds(100)
        .forEach(
            seed -> {
              RandomRun without = RandomRun.withoutAgents(RandomHomes.of(seed));
              RandomRun with = RandomRun.withAgents(RandomHomes.of(seed));
              softly.assertThat(with.agrees()).as(with.text()).isTrue();
              softly.assertThat(outcomes(with)).as(with.text()).isEqualTo(outcomes(without));
            });
    softly.assertAll();
  }

  private static List<Boolean> outcomes(RandomRun run) {
    return run.verdicts().stream().map(RandomHomesTest::isReached).toList();
  }

  private static boolean isReached(Verdict verdict) {
    return switch (verdict.kind()) {
      case ACHIEVED, ACHIEVED_CLOSELY, FALSELY_ACHIEVED -> true;
      default -> false;
    };
  }
}
