package org.maestro.assembly;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.fixtures.Share;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;

/**
 * A process is frozen for 1 to 30 s at any moment while Bob's cup is brought. Nothing is lost by
 * that but time: so the cup comes, and nothing is called impossible.
 */
class FreezeTest {
  private static final Duration LONGEST = Duration.ofMinutes(5);

  /** The job takes some 20 s. */
  private static final int LATEST_MILLIS = 20_000;

  /**
   * Of main alone, and of the whole. With the last one the camera's word from before the grasp is
   * heard after the robot's from behind it.
   */
  static LongStream fewSeeds() {
    return LongStream.of(2, 4, 8, 163);
  }

  static LongStream allSeeds() {
    return Share.of(LongStream.rangeClosed(1, 200));
  }

  @ParameterizedTest(name = "seed {0}")
  @MethodSource("fewSeeds")
  void nothingIsLostByAFreeze(long seed) throws Exception {
    bringsTheCup(seed);
  }

  @ParameterizedTest(name = "seed {0}")
  @MethodSource("allSeeds")
  @Tag("full")
  void nothingIsLostByAnyOfTwoHundred(long seed) throws Exception {
    bringsTheCup(seed);
  }

  private static void bringsTheCup(long seed) throws Exception {
    Random random = new Random(seed);
    Duration at = Duration.ofMillis(random.nextInt(LATEST_MILLIS));
    Duration lasting = Duration.ofMillis(1_000 + random.nextInt(29_000));
    boolean whole = random.nextInt(3) == 0;
    Home home = home();
    try (AgentlessSite site = AgentlessSite.start(home, scene(home), seed)) {
      List<GoalOutcome> ended = new ArrayList<>();
      site.pursue("(nextTo Cup Bob)", ended::add);
      site.clock()
          .schedule(
              at,
              "fault",
              () -> {
                if (whole) {
                  site.freezeWhole(lasting);
                } else {
                  site.freezeMain(lasting);
                }
              });
      site.runUntil(() -> !ended.isEmpty(), LONGEST);
      String told =
          "%s frozen at %s for %s:%n%s"
              .formatted(
                  whole ? "all" : "main",
                  at,
                  lasting,
                  site.story().stream().map(Object::toString).collect(Collectors.joining("\n")));
      assertThat(ended).as(told).singleElement().matches(GoalOutcome::reached, told);
      assertThat(site.world().position("Cup")).as(told).isPresent();
    }
  }

  private static Home home() throws Exception {
    try (var turtle = FreezeTest.class.getResourceAsStream("/homes/bob.ttl")) {
      return new HomeLoader().load(new String(turtle.readAllBytes()), "bob.ttl");
    }
  }

  private static Scene scene(Home home) throws Exception {
    try (var turtle = FreezeTest.class.getResourceAsStream("/scenes/bob-dark.ttl")) {
      return SceneLoader.load("bob-dark", turtle, home);
    }
  }
}
