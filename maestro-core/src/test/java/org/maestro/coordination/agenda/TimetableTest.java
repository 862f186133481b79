package org.maestro.coordination.agenda;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.DayOfWeek;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.ZonedDateTime;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;
import org.maestro.sl.Occasion;

/** No day is left out, and none has two, wherever clocks are put forward or back. */
class TimetableTest {
  private static final Set<DayOfWeek> EACH_DAY = EnumSet.allOf(DayOfWeek.class);
  private static final ZoneId BERLIN = ZoneId.of("Europe/Berlin");

  private static Timetable daily(String time, ZoneId zone) {
    return new Timetable(
        new Occasion.At(Optional.empty(), LocalTime.parse(time), EACH_DAY, true), zone);
  }

  private static List<String> from(String first, String before, String time) {
    Timetable times = daily(time, BERLIN);
    return Stream.iterate(
            times.next(Instant.parse(first)).orElseThrow(),
            moment -> moment.isBefore(Instant.parse(before)),
            moment -> times.next(moment).orElseThrow())
        .map(moment -> moment.atZone(BERLIN).toLocalDateTime() + " " + moment)
        .toList();
  }

  @Test
  void aTimeThatDoesNotExistComesAsMuchLater() {
    assertThat(from("2026-03-28T00:00:00Z", "2026-03-31T00:00:00Z", "02:30"))
        .containsExactly(
            "2026-03-28T02:30 2026-03-28T01:30:00Z",
            "2026-03-29T03:30 2026-03-29T01:30:00Z",
            "2026-03-30T02:30 2026-03-30T00:30:00Z");
  }

  @Test
  void aTimeThatComesTwiceCountsOnce() {
    assertThat(from("2026-10-24T00:00:00Z", "2026-10-27T00:00:00Z", "02:30"))
        .containsExactly(
            "2026-10-24T02:30 2026-10-24T00:30:00Z",
            "2026-10-25T02:30 2026-10-25T00:30:00Z",
            "2026-10-26T02:30 2026-10-26T01:30:00Z");
  }

  @Test
  void onceIsTodayOrTomorrow() {
    Timetable once =
        new Timetable(Occasion.At.once(Optional.empty(), LocalTime.of(22, 30)), BERLIN);

    assertThat(once.next(Instant.parse("2026-11-27T21:29:59Z")))
        .contains(Instant.parse("2026-11-27T21:30:00Z"));
    assertThat(once.next(Instant.parse("2026-11-27T21:30:00Z")))
        .contains(Instant.parse("2026-11-28T21:30:00Z"));
  }

  /** On a Friday before that time it is today, after it a week later. */
  @Test
  void onADayOfTheWeekIsTheNextSuchDay() {
    Timetable friday =
        new Timetable(
            new Occasion.At(Optional.empty(), LocalTime.of(9, 0), Set.of(DayOfWeek.FRIDAY), false),
            BERLIN);

    assertThat(friday.next(Instant.parse("2026-11-24T21:30:00Z")))
        .contains(Instant.parse("2026-11-27T08:00:00Z"));
    assertThat(friday.next(Instant.parse("2026-11-27T07:59:59Z")))
        .contains(Instant.parse("2026-11-27T08:00:00Z"));
    assertThat(friday.next(Instant.parse("2026-11-27T08:00:00Z")))
        .contains(Instant.parse("2026-12-04T08:00:00Z"));
  }

  @Test
  void aDateIsOverSometime() {
    Timetable eve =
        new Timetable(
            Occasion.At.once(Optional.of(LocalDate.of(2026, 12, 24)), LocalTime.of(18, 0)), BERLIN);

    assertThat(eve.next(Instant.parse("2026-11-27T21:30:00Z")))
        .contains(Instant.parse("2026-12-24T17:00:00Z"));
    assertThat(eve.next(Instant.parse("2026-12-24T17:00:00Z"))).isEmpty();
  }

  @Property(tries = 400)
  void eachDayHasOneMoment(
      @ForAll("zones") ZoneId zone,
      @ForAll @LongRange(min = 1_400_000_000L, max = 1_900_000_000L) long start,
      @ForAll @IntRange(max = 24 * 60 - 1) int minute) {
    LocalTime time = LocalTime.ofSecondOfDay(60L * minute);
    Timetable times = new Timetable(new Occasion.At(Optional.empty(), time, EACH_DAY, true), zone);
    Instant moment = Instant.ofEpochSecond(start);
    Optional<LocalDate> before = Optional.empty();
    for (int i = 0; i < 200; i++) {
      Instant next = times.next(moment).orElseThrow();
      assertThat(next).isAfter(moment);
      assertThat(times.next(next.minusMillis(1))).contains(next);
      ZonedDateTime shown = next.atZone(zone);
      if (!shown.toLocalTime().equals(time)) {
        LocalDate date = shown.toLocalDate();
        assertThat(zone.getRules().getValidOffsets(date.atTime(time)))
            .as("%s at %s", shown, time)
            .satisfiesAnyOf(
                none -> assertThat(none).isEmpty(),
                any ->
                    assertThat(zone.getRules().getValidOffsets(date.minusDays(1).atTime(time)))
                        .isEmpty());
      }
      if (before.isPresent()) {
        assertThat(Duration.between(moment, next))
            .isBetween(Duration.ofHours(20), Duration.ofHours(49));
        assertThat(shown.toLocalDate()).isAfter(before.get());
      }
      before = Optional.of(shown.toLocalDate());
      moment = next;
    }
  }

  @Property(tries = 100)
  void onlyThoseDaysOfTheWeek(
      @ForAll("zones") ZoneId zone,
      @ForAll("days") Set<DayOfWeek> days,
      @ForAll @LongRange(min = 1_400_000_000L, max = 1_900_000_000L) long start) {
    Timetable times =
        new Timetable(new Occasion.At(Optional.empty(), LocalTime.NOON, days, true), zone);
    Instant moment = Instant.ofEpochSecond(start);
    for (int i = 0; i < 20; i++) {
      moment = times.next(moment).orElseThrow();
      assertThat(days).contains(moment.atZone(zone).getDayOfWeek());
    }
  }

  @Provide
  Arbitrary<ZoneId> zones() {
    return Arbitraries.of(
            "Europe/Berlin",
            "Europe/London",
            "America/New_York",
            "America/Sao_Paulo",
            "America/St_Johns",
            "Australia/Lord_Howe",
            "Asia/Kathmandu",
            "Asia/Beirut",
            "Africa/Casablanca",
            "Pacific/Apia",
            "UTC")
        .map(ZoneId::of);
  }

  @Provide
  Arbitrary<Set<DayOfWeek>> days() {
    return Arbitraries.of(DayOfWeek.class).set().ofMinSize(1);
  }
}
