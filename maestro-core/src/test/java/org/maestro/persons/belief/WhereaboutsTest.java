package org.maestro.persons.belief;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
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
      assertThat(ZONES).map(now::guest).allMatch(share -> share >= 0 && share <= 1);
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

  /** Over all ways in which two persons and a guest can be spread, in a table of its own. */
  @Property(tries = 100)
  void ofSeveralPersonsAndAGuestItIsTheForwardAlgorithmOverAllWaysToBeSpread(@ForAll long seed) {
    Random random = new Random(seed);
    Whereabouts now = unknown("Dave", "Rose");
    int size = PLACES.size();
    double[][][] joint = new double[size][size][size];
    for (double[][] ofDave : joint) {
      for (double[] ofRose : ofDave) {
        for (int guest = 0; guest < size; guest++) {
          ofRose[guest] = guest == PLACES.away() ? 1 - 4 * 0.002 : 0.002;
        }
      }
    }
    for (int i = 0; i < 12; i++) {
      Evidence evidence = any(random, List.of("Dave", "Rose"));
      now = now.given(evidence);
      weigh(joint, evidence);
    }
    double sum = 0;
    double[] dave = new double[size];
    double[] guests = new double[size];
    for (int ofDave = 0; ofDave < size; ofDave++) {
      for (int ofRose = 0; ofRose < size; ofRose++) {
        for (int guest = 0; guest < size; guest++) {
          sum += joint[ofDave][ofRose][guest];
          dave[ofDave] += joint[ofDave][ofRose][guest];
          guests[guest] += joint[ofDave][ofRose][guest];
        }
      }
    }
    for (String place : PLACES.names()) {
      assertThat(now.probability("Dave", place))
          .isCloseTo(dave[PLACES.number(place)] / sum, within(1e-6));
      assertThat(now.guest(place)).isCloseTo(guests[PLACES.number(place)] / sum, within(1e-6));
    }
  }

  private static void weigh(double[][][] joint, Evidence evidence) {
    int zone = PLACES.number(evidence.zone());
    for (int dave = 0; dave < joint.length; dave++) {
      for (int rose = 0; rose < joint.length; rose++) {
        for (int guest = 0; guest < joint.length; guest++) {
          int there = (dave == zone ? 1 : 0) + (rose == zone ? 1 : 0) + (guest == zone ? 1 : 0);
          double silent = (1 - evidence.falseRate()) * Math.pow(1 - evidence.hitRate(), there);
          boolean isThere =
              evidence.person().equals(Optional.of("Dave")) ? dave == zone : rose == zone;
          joint[dave][rose][guest] *=
              evidence.person().isPresent()
                  ? isThere ? evidence.likelihoodWhereSo() : evidence.likelihoodElsewhere()
                  : evidence.said() ? 1 - silent : silent;
        }
      }
    }
  }

  @Test
  void ofTwoOneIsEnoughHoweverOftenItIsSaid() {
    Whereabouts now = unknown("Dave", "Rose");
    now = now.given(seen("Dave", "hall")).given(seen("Rose", "hall")).after(Duration.ofMinutes(1));
    double once = now.given(motion("bed", true)).probability("Dave", "bed");
    for (int i = 0; i < 10; i++) {
      now = now.given(motion("bed", true));
    }

    assertThat(once).isLessThan(0.7);
    assertThat(now.probability("Dave", "bed")).isLessThan(0.7);
  }

  @Property(tries = 20)
  void aLargeHouseholdIsFollowedInGroups(@ForAll long seed) {
    Random random = new Random(seed);
    List<String> persons = IntStream.range(0, 20).mapToObj(i -> "P" + i).toList();
    Whereabouts now =
        Whereabouts.unknown(persons, MOVEMENT, 0.002, Duration.ofHours(1))
            .given(seen("P19", "bed"))
            .after(Duration.ofSeconds(1));
    assertThat(now.likeliest("P19").place()).isEqualTo("bed");
    for (int i = 0; i < 10; i++) {
      now = now.given(any(random, persons)).after(Duration.ofSeconds(7));
    }
    for (String person : persons) {
      double sum = now.of(person).stream().mapToDouble(Whereabouts.Likely::probability).sum();
      assertThat(sum).isCloseTo(1, within(EXACT));
    }
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
