package org.maestro.persons.belief;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/**
 * A filter over the rooms of a small house: {@code bed - hall - living - kitchen}, out by the hall.
 */
class WhereaboutsTest {
  private static final List<String> ZONES = List.of("bed", "hall", "living", "kitchen");
  private static final Places PLACES =
      Places.of(
          ZONES, (a, b) -> Math.abs(ZONES.indexOf(a) - ZONES.indexOf(b)) == 1, Set.of("hall"));
  private static final Movement MOVEMENT =
      new Movement(PLACES, Duration.ofMinutes(3), Duration.ofHours(1));
  private static final double EXACT = 1e-9;

  private static Whereabouts unknown(String... persons) {
    return Whereabouts.unknown(List.of(persons), MOVEMENT, 0.002, Duration.ofHours(1));
  }

  private static Evidence seen(String person, String zone) {
    return new Evidence(Optional.of(person), zone, true, 0.98, 1e-6);
  }

  private static Evidence motion(String zone, boolean said) {
    return new Evidence(Optional.empty(), zone, said, 0.95, 0.02);
  }

  private static Evidence any(Random random, List<String> persons) {
    double falseRate = 0.001 + 0.4 * random.nextDouble();
    Optional<String> person =
        random.nextBoolean()
            ? Optional.of(persons.get(random.nextInt(persons.size())))
            : Optional.empty();
    return new Evidence(
        person,
        ZONES.get(random.nextInt(ZONES.size())),
        random.nextBoolean(),
        falseRate + (0.999 - falseRate) * random.nextDouble(),
        falseRate);
  }

  @Property(tries = 300)
  void whateverIsNoticedProbabilitiesOfAPersonAddUpToOne(@ForAll long seed) {
    Random random = new Random(seed);
    List<String> persons = List.of("Dave", "Rose", "Tom");
    Whereabouts now = unknown("Dave", "Rose", "Tom");
    for (int i = 0; i < 40; i++) {
      now =
          random.nextBoolean()
              ? now.after(Duration.ofMillis(random.nextInt(600_000)))
              : now.given(any(random, persons));
      for (String person : persons) {
        double sum = now.of(person).stream().mapToDouble(Whereabouts.Likely::probability).sum();
        assertThat(sum).isCloseTo(1, within(EXACT));
        assertThat(now.of(person)).allMatch(one -> one.probability() >= 0);
      }
      assertThat(ZONES).map(now::guest).allMatch(share -> share >= 0 && share < 1);
    }
  }

  @Property(tries = 200)
  void ofOnePersonItIsTheForwardAlgorithmOfAHiddenMarkovModel(@ForAll long seed) {
    Random random = new Random(seed);
    Whereabouts now = unknown("Dave");
    double[] forward = new double[PLACES.size()];
    Arrays.fill(forward, 1.0 / forward.length);
    for (int i = 0; i < 10; i++) {
      Duration time = Duration.ofSeconds(random.nextInt(300));
      Evidence evidence =
          new Evidence(
              Optional.of("Dave"), ZONES.get(random.nextInt(4)), random.nextBoolean(), 0.9, 0.05);
      now = now.after(time).given(evidence);
      forward = weighed(inSmallSteps(forward, time), evidence);
    }
    for (String place : PLACES.names()) {
      assertThat(now.probability("Dave", place))
          .isCloseTo(forward[PLACES.number(place)], within(2e-3));
    }
  }

  /** Euler's method, a hundredth of a second at a time: slow, and of another kind. */
  private static double[] inSmallSteps(double[] before, Duration time) {
    double[] now = before.clone();
    for (int step = 0; step < time.toMillis() / 100; step++) {
      double[] next = now.clone();
      for (int place = 0; place < now.length; place++) {
        double leaving = now[place] * 0.1 / (place == PLACES.away() ? 3600 : 180);
        next[place] -= leaving;
        for (int beside : PLACES.beside(place)) {
          next[beside] += leaving / PLACES.beside(place).length;
        }
      }
      now = next;
    }
    return now;
  }

  private static double[] weighed(double[] row, Evidence evidence) {
    double sum = 0;
    for (int place = 0; place < row.length; place++) {
      row[place] *=
          place == PLACES.number(evidence.zone())
              ? evidence.likelihoodWhereSo()
              : evidence.likelihoodElsewhere();
      sum += row[place];
    }
    for (int place = 0; place < row.length; place++) {
      row[place] /= sum;
    }
    return row;
  }

  /** Over all combinations of where two persons are, and whether a guest is there. */
  @Property(tries = 300)
  void whatNamesNobodyIsSharedOutExactlyAmongThoseWhoCanBeThere(@ForAll long seed) {
    Random random = new Random(seed);
    Whereabouts before = unknown("Dave", "Rose");
    for (int i = 0; i < 4; i++) {
      before = before.given(any(random, List.of("Dave", "Rose"))).after(Duration.ofSeconds(20));
    }
    Evidence evidence = new Evidence(Optional.empty(), "living", random.nextBoolean(), 0.9, 0.03);
    double[] dave = new double[PLACES.size()];
    double guests = 0;
    double sum = 0;
    for (String ofDave : PLACES.names()) {
      for (String ofRose : PLACES.names()) {
        for (int guest = 0; guest <= 1; guest++) {
          int there = (ofDave.equals("living") ? 1 : 0) + (ofRose.equals("living") ? 1 : 0) + guest;
          double silent = 0.97 * Math.pow(0.1, there);
          double joint =
              before.probability("Dave", ofDave)
                  * before.probability("Rose", ofRose)
                  * (guest == 1 ? before.guest("living") : 1 - before.guest("living"))
                  * (evidence.said() ? 1 - silent : silent);
          sum += joint;
          dave[PLACES.number(ofDave)] += joint;
          guests += guest * joint;
        }
      }
    }
    Whereabouts after = before.given(evidence);
    for (String place : PLACES.names()) {
      assertThat(after.probability("Dave", place))
          .isCloseTo(dave[PLACES.number(place)] / sum, within(EXACT));
    }
    assertThat(after.guest("living")).isCloseTo(Math.min(0.999, guests / sum), within(EXACT));
  }

  @Property(tries = 100)
  void itDoesNotMatterHowOftenOneLooksWhileNothingIsNoticed(
      @ForAll @IntRange(min = 1, max = 7200) int seconds,
      @ForAll @IntRange(min = 1, max = 9) int parts) {
    Whereabouts begun = unknown("Dave").given(seen("Dave", "kitchen"));
    Whereabouts often = begun;
    for (int i = 0; i < parts; i++) {
      often = often.after(Duration.ofNanos(seconds * 1_000_000_000L / parts));
    }
    Whereabouts once = begun.after(Duration.ofSeconds(seconds));
    for (String place : PLACES.names()) {
      assertThat(often.probability("Dave", place))
          .isCloseTo(once.probability("Dave", place), within(1e-6));
    }
  }

  @Test
  void nobodyGoesThroughWalls() {
    Whereabouts now = unknown("Dave").given(seen("Dave", "bed")).given(seen("Dave", "bed"));
    Whereabouts later = now.after(Duration.ofSeconds(5));

    assertThat(later.probability("Dave", "bed")).isGreaterThan(0.95);
    assertThat(later.probability("Dave", "hall"))
        .isGreaterThan(50 * later.probability("Dave", "living"));
    assertThat(later.probability("Dave", "living"))
        .isGreaterThan(50 * later.probability("Dave", "kitchen"));
  }

  @Test
  void somebodyWhereNobodyKnownCanBeStaysAGuest() {
    Whereabouts now = unknown("Dave");
    for (int i = 0; i < 4; i++) {
      now =
          now.after(Duration.ofSeconds(10))
              .given(seen("Dave", "kitchen"))
              .given(motion("kitchen", true))
              .given(motion("bed", true));
    }

    assertThat(now.guest("bed")).isGreaterThan(0.9);
    assertThat(now.guest("kitchen")).isLessThan(0.1);
    assertThat(now.likeliest("Dave").place()).isEqualTo("kitchen");
    assertThat(now.probability("Dave", "bed")).isLessThan(1e-6);
  }

  @Test
  void somebodyWhoMayBeEitherIsNeitherForSure() {
    Whereabouts now =
        unknown("Dave", "Rose")
            .given(seen("Dave", "hall"))
            .given(seen("Rose", "hall"))
            .after(Duration.ofMinutes(1))
            .given(motion("bed", true));

    assertThat(now.probability("Dave", "bed")).isBetween(0.2, 0.7);
    assertThat(now.probability("Dave", "bed"))
        .isCloseTo(now.probability("Rose", "bed"), within(EXACT));
  }

  @Test
  void aRoomInWhichNothingMovesIsLeft() {
    Whereabouts now = unknown("Dave").given(seen("Dave", "living")).given(motion("living", true));
    now = now.after(Duration.ofMinutes(2));
    double before = now.probability("Dave", "living");
    for (int i = 0; i < 3; i++) {
      now = now.given(motion("living", false)).after(Duration.ofSeconds(10));
    }

    assertThat(now.probability("Dave", "living")).isLessThan(0.1 * before);
  }

  @Test
  void whatASourceIsNotSureOfCountsLess() {
    Whereabouts begun = unknown("Dave");
    Evidence sure = new Evidence(Optional.of("Dave"), "living", true, 0.9, 0.05);

    double half = begun.given(sure.weakened(0.5)).probability("Dave", "living");
    assertThat(half)
        .isBetween(
            begun.probability("Dave", "living"), begun.given(sure).probability("Dave", "living"));
    assertThat(begun.given(sure.weakened(0)).probability("Dave", "living"))
        .isCloseTo(begun.probability("Dave", "living"), within(EXACT));
  }

  @Test
  void whoStaysAmongThePersonsStaysWhereSheWas() {
    Whereabouts now = unknown("Dave", "Rose").given(seen("Dave", "living"));
    Whereabouts others = now.of(List.of("Dave", "Tom"), MOVEMENT);

    assertThat(others.probability("Dave", "living"))
        .isCloseTo(now.probability("Dave", "living"), within(EXACT));
    assertThat(others.probability("Tom", "living")).isCloseTo(0.2, within(EXACT));
  }
}
