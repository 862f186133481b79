package org.maestro.coordination.api;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.Optional;
import java.util.OptionalDouble;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The formulas of ADE, 4.1, with numbers worked by hand. */
class WorthTest {

  /** u = p·b − c; g = (te/ta)(gmax − gmin) + gmin; priority = u·g. */
  @ParameterizedTest
  @CsvSource({
    // p,  b,   c,    te,  ta,  gmin, gmax, u,     g,    u·g
    "0.8,  60,  14,   0,   600, 1,    10,   34,    1,    34",
    "0.8,  60,  14,   60,  600, 1,    10,   34,    1.9,  64.6",
    "0.8,  60,  14,   300, 600, 1,    10,   34,    5.5,  187",
    "0.8,  60,  14,   600, 600, 1,    10,   34,    10,   340",
    "0.8,  60,  14,   900, 600, 1,    10,   34,    10,   340",
    "0.5,  100, 20,   30,  120, 2,    4,    30,    2.5,  75",
    "1,    10,  0,    50,  100, 1,    1,    10,    1,    10",
    "0.25, 40,  10,   10,  20,  1,    3,    0,     2,    0",
    "0.1,  80,  14.2, 300, 600, 1,    10,   -6.2,  5.5,  -34.1",
    "0,    80,  5,    0,   600, 1,    10,   -5,    1,    -5",
  })
  void isAsThePaperPrintsIt(
      double chance,
      double benefit,
      double cost,
      long elapsed,
      long allowed,
      double from,
      double to,
      double utility,
      double urgency,
      double priority) {
    Worth worth = worth(chance, benefit, cost, elapsed, Optional.of(allowed), from, to);

    assertThat(worth.utility().orElseThrow()).isCloseTo(utility, within(1e-9));
    assertThat(worth.urgency()).isCloseTo(urgency, within(1e-9));
    assertThat(worth.priority().orElseThrow()).isCloseTo(priority, within(1e-9));
    assertThat(worth.isWorthIt()).isEqualTo(utility > 0);
  }

  @Test
  void urgencyIsALineUpToTheTimeAllowedAndLevelFromThereOn() {
    double before = 0;
    for (long second = 0; second <= 100; second++) {
      double urgency = worth(1, 10, 0, second, Optional.of(100L), 1, 10).urgency();
      assertThat(urgency).isCloseTo(1 + 9 * second / 100.0, within(1e-9)).isGreaterThan(before);
      before = urgency;
    }
    for (long second = 100; second <= 1000; second += 50) {
      assertThat(worth(1, 10, 0, second, Optional.of(100L), 1, 10).urgency()).isEqualTo(10);
    }
  }

  @Test
  void withoutATimeItDoesNotGrow() {
    Worth worth = worth(1, 10, 0, 1_000_000, Optional.empty(), 2, 10);

    assertThat(worth.urgency()).isEqualTo(2);
    assertThat(worth.nextGradeAt()).isEmpty();
  }

  @Test
  void aBenefitThatNobodyKnowsIsNotZero() {
    Worth worth =
        new Worth(0.8, 0, OptionalDouble.empty(), 12, Duration.ZERO, Optional.empty(), 1, 10);

    assertThat(worth.utility()).isEmpty();
    assertThat(worth.isWorthIt()).isTrue();
    assertThat(worth.grade()).isEqualTo(GoalPriority.UNWEIGHED);
    assertThat(worth.inWords()).contains("not known");
  }

  @Test
  void whatCostsMoreThanItBringsIsOfTheLowestGradeHoweverUrgent() {
    assertThat(worth(0.1, 80, 14.2, 600, Optional.of(600L), 1, 10).grade())
        .isEqualTo(GoalPriority.WORTHLESS);
    assertThat(worth(0.1, 80, 14.2, 600, Optional.of(600L), 1, 10).deficitInWords())
        .isEqualTo("not worth it: 8 against 14.2");
  }

  @Test
  void tellsTheFormulasWithTheirNumbers() {
    assertThat(worth(0.8, 60, 14, 60, Optional.of(600L), 1, 10).inWords())
        .isEqualTo(
            "u = 0.8·60 − 14 = 34; g = (60 s / 600 s)·(10 − 1) + 1 = 1.9; priority u·g = 64.6");
  }

  /** A goal that is looked at at the time told is of another grade, and was not just before. */
  @Property
  void theNextGradeComesWhenItIsTold(
      @ForAll @DoubleRange(min = 0.1, max = 10_000) double benefit,
      @ForAll @IntRange(max = 3_599) int elapsed,
      @ForAll @DoubleRange(min = 1, max = 20) double to) {
    Worth now = worth(1, benefit, 0, elapsed, Optional.of(3_600L), 1, to);

    now.nextGradeAt()
        .ifPresent(
            at -> {
              assertThat(at).isGreaterThan(now.elapsed());
              assertThat(at(now, at.plusMillis(1)).grade()).isGreaterThan(now.grade());
              Duration before = at.minusMillis(3);
              if (before.compareTo(now.elapsed()) > 0) {
                assertThat(at(now, before).grade()).isEqualTo(now.grade());
              }
            });
    if (now.nextGradeAt().isEmpty()) {
      assertThat(at(now, Duration.ofHours(2)).grade()).isEqualTo(now.grade());
    }
  }

  private static Worth at(Worth worth, Duration elapsed) {
    return new Worth(
        worth.chance(),
        worth.tried(),
        worth.benefit(),
        worth.cost(),
        elapsed,
        worth.allowed(),
        worth.urgencyFrom(),
        worth.urgencyTo());
  }

  private static Worth worth(
      double chance,
      double benefit,
      double cost,
      long elapsed,
      Optional<Long> allowed,
      double from,
      double to) {
    return new Worth(
        chance,
        0,
        OptionalDouble.of(benefit),
        cost,
        Duration.ofSeconds(elapsed),
        allowed.map(Duration::ofSeconds),
        from,
        to);
  }
}
