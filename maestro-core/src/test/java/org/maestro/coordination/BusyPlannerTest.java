package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.SlParser;

/** What is due is done in its time, however long the planner is at something else. */
class BusyPlannerTest {
  private static final Duration BUSY = Duration.ofSeconds(5);
  private static final Duration TOLERANCE = Duration.ofMillis(50);
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = BusyPlannerTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  @Test
  void aDeadlinePassesInItsTime() {
    PretendHouse house = new PretendHouse(home);
    house.planningTakes = BUSY;
    Duration deadline = house.clock.now().plusSeconds(1);
    List<GoalOutcome> ended = new ArrayList<>();

    house.coordinator.submit(
        new GoalRequest(SlParser.formula("(in rose zone-a)"), "Bob", 0, Optional.of(deadline)),
        ended::add);
    house.clock.runUntil(() -> !ended.isEmpty(), Duration.ofMinutes(1));

    assertThat(ended.get(0).state()).isEqualTo(GoalState.FAILED);
    assertThat(ended.get(0).endedAt()).isBetween(deadline, deadline.plus(TOLERANCE));
  }

  @Test
  void aReportIsMissedInItsTime() {
    Duration usual = missed(Optional.empty());

    Duration besideAPlan = missed(Optional.of(usual.minusSeconds(1)));

    assertThat(besideAPlan).isBetween(usual, usual.plus(TOLERANCE));
  }

  /**
   * When it is told that the robot has not answered.
   *
   * @param busyFrom when another goal begins to be planned
   */
  private static Duration missed(Optional<Duration> busyFrom) {
    PretendHouse house = new PretendHouse(home);
    house.mute.add("rose");
    house.coordinator.submit(
        new GoalRequest(SlParser.formula("(in rose zone-a)"), "Bob"), outcome -> {});
    busyFrom.ifPresent(
        from ->
            house.clock.schedule(
                from.minus(house.clock.now()),
                "another",
                () -> {
                  house.planningTakes = BUSY;
                  house.coordinator.submit(
                      new GoalRequest(SlParser.formula("(>= (level lamp-b1) 0.5)"), "Rose"),
                      outcome -> {});
                }));
    house.clock.runUntil(() -> toldOfSilence(house).isPresent(), Duration.ofMinutes(5));
    return Duration.parse(toldOfSilence(house).orElseThrow().split(" ", 2)[0]);
  }

  private static Optional<String> toldOfSilence(PretendHouse house) {
    return house.story.stream().filter(told -> told.contains("has not answered")).findFirst();
  }
}
