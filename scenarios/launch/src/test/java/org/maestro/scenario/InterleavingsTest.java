package org.maestro.scenario;

import static org.maestro.junit.MaestroAssertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.maestro.assembly.SiteSettings;
import org.maestro.fixtures.Share;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;

/** Whatever comes first of what is due at the same time, goals are reached. */
@Execution(ExecutionMode.CONCURRENT)
class InterleavingsTest {
  private static final List<String> TEN =
      List.of(
          "(nextTo Cup Bob)",
          "(>= (illuminance zone-a) 72)",
          "(>= (illuminance zone-b) 72)",
          "(in Cup ?where)",
          "(in Bob ?where)",
          "(>= (level lamp-b1) 0.5)",
          "(>= (level lamp-b2) 0.5)",
          "(nextTo Cup Bob)",
          "(>= (illuminance zone-a) 50)",
          "(>= (level lamp-a1) 0.5)");

  static LongStream some() {
    return LongStream.rangeClosed(1, 2);
  }

  static LongStream all() {
    return Share.of(LongStream.rangeClosed(1, 200));
  }

  @ParameterizedTest(name = "order {0}")
  @MethodSource("some")
  void bobGetsHisCup(long seed) {
    bringTheCup(seed);
  }

  @ParameterizedTest(name = "order {0}")
  @MethodSource("all")
  @Tag("full")
  void bobGetsHisCupInTwoHundredOrders(long seed) {
    bringTheCup(seed);
  }

  @ParameterizedTest(name = "order {0}")
  @MethodSource("some")
  void tenGoalsAtOnceAreReached(long seed) {
    reachTen(seed);
  }

  @ParameterizedTest(name = "order {0}")
  @MethodSource("all")
  @Tag("full")
  void tenGoalsAtOnceAreReachedInTwoHundredOrders(long seed) {
    reachTen(seed);
  }

  private static void bringTheCup(long seed) {
    try (Stage stage = Stage.shuffled(settings("cup", seed), seed)) {
      assertThat(stage.goal("(nextTo Cup Bob)")).isReached().hasCallsAtMost(16);
      assertThat(stage.world()).hasNextTo("Cup", "Bob");
    }
  }

  private static void reachTen(long seed) {
    try (Stage stage = Stage.shuffled(settings("ten", seed), seed)) {
      List<Pursuit> ten = TEN.stream().map(stage::begin).toList();

      for (Pursuit one : ten) {
        GoalOutcome outcome = one.await();
        assertThat(outcome).isReached();
      }
      assertThat(stage.world()).hasNextTo("Cup", "Bob");
    }
  }

  private static SiteSettings settings(String what, long seed) {
    Home home = new HomeLoader().load(text("/homes/bob.ttl"), "bob.ttl");
    return SiteSettings.of("order-" + what + "-" + seed, home).scene(scene(home)).build();
  }

  private static Scene scene(Home home) {
    try (InputStream turtle = InterleavingsTest.class.getResourceAsStream("/scenes/bob-dark.ttl")) {
      return SceneLoader.load("bob-dark.ttl", turtle, home);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String text(String resource) {
    try (InputStream turtle = InterleavingsTest.class.getResourceAsStream(resource)) {
      return new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
