package org.maestro.random;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.maestro.assembly.AgentlessSite;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.fixtures.Share;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;

/**
 * Where it is plain what can be done, it is done; where it is plain that nobody can, that is said.
 * No way, hands too small or too weak, too little time. A home has a world and a clock of its own,
 * so its tests run beside each other.
 */
@Execution(ExecutionMode.CONCURRENT)
class KnownHomesTest {
  private static final Duration LONGEST = Duration.ofMinutes(5);

  /** A timer, and a thought that is under way. */
  private static final Duration TOLD_WITHIN = Duration.ofSeconds(1);

  static LongStream someSeeds() {
    return LongStream.rangeClosed(1, 3);
  }

  static LongStream allSeeds() {
    return Share.of(LongStream.rangeClosed(1, 200));
  }

  @ParameterizedTest(name = "way {0}")
  @MethodSource("someSeeds")
  void goesWhereThereIsAWay(long seed) {
    judge(seed, KnownHome.Kind.WAY);
  }

  @ParameterizedTest(name = "cup {0}")
  @MethodSource("someSeeds")
  void bringsWhatAHandCanHold(long seed) {
    judge(seed, KnownHome.Kind.CUP);
  }

  @ParameterizedTest(name = "time {0}")
  @MethodSource("someSeeds")
  void isDoneInTimeOrSaidToBeLate(long seed) {
    judgeTime(seed);
  }

  @ParameterizedTest(name = "way {0}")
  @MethodSource("allSeeds")
  @Tag("full")
  void goesWhereThereIsAWayInTwoHundredHomes(long seed) {
    judge(seed, KnownHome.Kind.WAY);
  }

  @ParameterizedTest(name = "cup {0}")
  @MethodSource("allSeeds")
  @Tag("full")
  void bringsWhatAHandCanHoldInTwoHundredHomes(long seed) {
    judge(seed, KnownHome.Kind.CUP);
  }

  @ParameterizedTest(name = "time {0}")
  @MethodSource("allSeeds")
  @Tag("full")
  void isDoneInTimeOrSaidToBeLateInTwoHundredHomes(long seed) {
    judgeTime(seed);
  }

  private static void judge(long seed, KnownHome.Kind kind) {
    KnownHome home = new KnownHome(seed, kind);
    Run run = run(home, seed, Optional.empty());
    assertThat(run.outcome().reached()).as(run.told()).isEqualTo(home.isPossible());
  }

  /** The same is asked for with more and with less time than it takes. */
  private static void judgeTime(long seed) {
    KnownHome home = new KnownHome(seed, KnownHome.Kind.WAY);
    Run free = run(home, seed, Optional.empty());
    Duration taken = free.ended().minus(free.begun());
    Run enough = run(home, seed, Optional.of(taken.plus(TOLD_WITHIN)));
    assertThat(enough.outcome().reached()).as(enough.told()).isEqualTo(free.outcome().reached());
    Duration half = taken.dividedBy(2);
    if (half.compareTo(TOLD_WITHIN) > 0) {
      Run tooShort = run(home, seed, Optional.of(half));
      assertThat(tooShort.outcome().reached()).as(tooShort.told()).isFalse();
      assertThat(String.join(" ", tooShort.outcome().reasons()))
          .as(tooShort.told())
          .contains("Its deadline has passed")
          .doesNotContain("obody can");
      assertThat(tooShort.ended().minus(tooShort.begun()))
          .as(tooShort.told())
          .isLessThanOrEqualTo(half.plus(TOLD_WITHIN));
    }
  }

  private record Run(GoalOutcome outcome, Duration begun, Duration ended, String told) {}

  private static Run run(KnownHome known, long seed, Optional<Duration> within) {
    Home home = new HomeLoader().load(known.homeText(), "known.ttl");
    try (AgentlessSite site =
        AgentlessSite.start(
            home,
            SceneLoader.load(
                "known",
                new ByteArrayInputStream(known.sceneText().getBytes(StandardCharsets.UTF_8)),
                home),
            seed)) {
      List<GoalOutcome> ended = new ArrayList<>();
      Duration begun = site.clock().now();
      site.coordinator()
          .submit(
              new GoalRequest(site.parsed(known.goal()), "somebody", 0, within.map(begun::plus)),
              ended::add);
      site.runUntil(() -> !ended.isEmpty(), LONGEST);
      String told =
          known.goal()
              + site.story().stream()
                  .map(ArenaWithoutAgents::line)
                  .collect(Collectors.joining("\n", "\n", "\n"))
              + known.homeText()
              + known.sceneText();
      assertThat(ended).as(told).hasSize(1);
      return new Run(ended.get(0), begun, site.clock().now(), told);
    }
  }
}
