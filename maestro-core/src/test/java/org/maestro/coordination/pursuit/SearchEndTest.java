package org.maestro.coordination.pursuit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.PretendHouse;
import org.maestro.coordination.achievement.SearchLog;
import org.maestro.coordination.achievement.SearchReview;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.SearchReport;
import org.maestro.coordination.story.ObstacleSentences;
import org.maestro.coordination.story.SearchSentences;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Planner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningResult.Obstacle;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;
import org.maestro.sl.SlParser;

/** Searches that find nothing end, and tell what was looked at and what could not be. */
class SearchEndTest {
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = SearchEndTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  private final PretendHouse house = new PretendHouse(home);

  private SearchReport report(GoalOutcome outcome, String thing) {
    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(outcome.searches())
        .as(String.join("\n", house.story))
        .extracting(SearchReport::thing)
        .contains(thing);
    return outcome.searches().stream()
        .filter(report -> report.thing().equals(thing))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void tellsWhereItWasLookedByWhomAndWhen() {
    house.place.put("Cup", "nowhere");

    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    SearchReport report = report(outcome, "Cup");
    assertThat(report.looks())
        .extracting(SearchReport.Look::place, SearchReport.Look::by)
        .containsExactlyInAnyOrder(tuple("zone-a", "cam-a"), tuple("zone-b", "cam-b"));
    assertThat(report.looks())
        .allSatisfy(
            look -> {
              assertThat(look.at()).isPositive();
              assertThat(look.coveredShare().orElse(0)).isGreaterThan(0.95);
            });
    assertThat(report.gaps()).isEmpty();
    assertThat(String.join(" ", outcome.reasons()))
        .contains("Cup was looked for in vain")
        .containsPattern("in zone-a by cam-a \\d+(\\.\\d+)? s ago");
    assertThat(house.story).anyMatch(text -> text.contains("Cup was looked for in vain"));
  }

  @Test
  void tellsWhoIsMissedWhereNobodyLooked() {
    house.place.put("Cup", "nowhere");
    house.coordinator.memberLost("cam-b", "no power");

    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    SearchReport report = report(outcome, "Cup");
    assertThat(report.gaps()).hasSize(1);
    assertThat(report.gaps().get(0).place()).isEqualTo("zone-b");
    assertThat(report.gaps().get(0).reason()).isEqualTo(SearchReport.Reason.MEMBERS_LOST);
    assertThat(report.gaps().get(0).obstacles())
        .extracting(Obstacle::condition)
        .containsExactly("cam-b");
    assertThat(String.join(" ", outcome.reasons()))
        .contains("zone-b, which was not looked at. cam-b is needed and not there (no power)");
  }

  @Test
  void placesThatNobodyLookedAtForTheSameReasonAreToldTogether() {
    SearchReport report =
        new SearchReport(
            "in",
            "Cup",
            List.of(),
            List.of(
                new SearchReport.Gap("zone-a", SearchReport.Reason.OF_NO_USE, List.of()),
                new SearchReport.Gap("attic", SearchReport.Reason.NOBODY_CAN, List.of()),
                new SearchReport.Gap("zone-b", SearchReport.Reason.OF_NO_USE, List.of())));

    assertThat(
            new SearchSentences(
                    new ObstacleSentences(home, house.knowledge.snapshot()), Duration.ZERO)
                .of(report))
        .containsExactly(
            "Where Cup may still be: zone-a, zone-b, where nobody looked, as that alone would not"
                + " have helped. attic, into which nobody can look.");
  }

  /** Then it is not known whether a look would have helped. */
  @Test
  void whereItWasTooMuchToPlanALookNothingIsSaidOfItsUse() {
    SearchReview review =
        new SearchReview(
            home,
            house.knowledge.snapshot(),
            new TooMuchForIt(),
            List.of(),
            Set.of(),
            List.of(),
            new SearchLog("G1", Journal.none()),
            house.clock);

    List<SearchReport> reports = review.reports(SlParser.formula("(nextTo Cup Bob)"));

    assertThat(reports).hasSize(2);
    assertThat(reports)
        .flatExtracting(SearchReport::gaps)
        .extracting(SearchReport.Gap::reason)
        .containsOnly(SearchReport.Reason.NOT_DECIDED);
    assertThat(
            new SearchSentences(
                    new ObstacleSentences(home, house.knowledge.snapshot()), Duration.ZERO)
                .of(reports.get(0)))
        .singleElement()
        .asString()
        .contains("whether anybody could was too much to be planned");
  }

  /** A story counts its time from where its goal began, a look from where the platform did. */
  @Test
  void tellsTheAgeOfALookThoughThePlatformHasRunForAnHour() {
    Duration anHour = Duration.ofHours(1);
    SearchReport report =
        new SearchReport(
            "in",
            "Cup",
            List.of(
                new SearchReport.Look(
                    "zone-a", "cam-a", anHour.minusMillis(2_500), OptionalDouble.of(1))),
            List.of());

    assertThat(
            new SearchSentences(new ObstacleSentences(home, house.knowledge.snapshot()), anHour)
                .of(report))
        .containsExactly(
            "Cup was looked for in vain: in zone-a by cam-a 2.5 s ago (100 % of it in view).");
  }

  @Test
  void tellsWhatItWasTooDarkFor() {
    house.place.put("Cup", "nowhere");
    for (String lamp : new String[] {"lamp-b1", "lamp-b2", "lamp-b3"}) {
      house.weak.add(lamp);
    }
    house.ambientLux.put("zone-b", 1.0);

    SearchReport report = report(house.achieve("(nextTo Cup Bob)"), "Cup");

    SearchReport.Gap gap = report.gaps().get(0);
    assertThat(gap.place()).isEqualTo("zone-b");
    assertThat(gap.reason()).isEqualTo(SearchReport.Reason.CONDITION);
    assertThat(gap.obstacles())
        .extracting(Obstacle::condition)
        .containsExactly("(>= (illuminance zone-b) 72)");
  }

  @Test
  void doesNotGoRoundForEverWhenWhatWasSeenAgesFasterThanItIsLookedAt() {
    house.place.put("Bob", "nowhere");
    house.stepTakes = Duration.ofSeconds(40);

    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    SearchReport report = report(outcome, "Bob");
    assertThat(report.looks()).extracting(SearchReport.Look::place).contains("zone-a");
    assertThat(report.gaps())
        .extracting(SearchReport.Gap::reason)
        .containsOnly(SearchReport.Reason.LOOKED_IN_VAIN);
    for (String camera : new String[] {"cam-a", "cam-b"}) {
      assertThat(house.calls.stream().filter(call -> call.equals("observeObject " + camera)))
          .hasSizeLessThanOrEqualTo(2 * SearchLog.ROUNDS);
    }
  }

  private static final class TooMuchForIt implements Planner {
    @Override
    public PlanningResult plan(PlanningTask task) {
      return new PlanningResult.GaveUp("too many states");
    }

    @Override
    public Optional<Plan> revalidate(PlanningTask task, List<Step> steps) {
      return Optional.empty();
    }
  }
}
