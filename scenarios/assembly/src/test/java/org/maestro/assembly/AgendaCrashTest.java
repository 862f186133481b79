package org.maestro.assembly;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.ZoneId;
import java.util.List;
import java.util.Set;
import java.util.stream.LongStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.fixtures.Share;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;

/**
 * The coordinator dies while something waits for its time: what was missed is told and not done,
 * what is yet to come is done, and nothing is done twice.
 */
class AgendaCrashTest {
  private static final String LATER = "(after 2 (>= (illuminance zone-a) 75))";
  private static final String ONCE =
      "(once (exists (?z - Zone) (in rose ?z)) (>= (illuminance zone-a) 75))";
  private static Home home;
  private static Scene scene;

  @TempDir Path directory;

  @BeforeAll
  static void load() throws IOException {
    home = new HomeLoader().load(text("/homes/bob.ttl"), "bob.ttl").in(ZoneId.of("UTC"));
    scene =
        SceneLoader.load(
            "bob-dark",
            new ByteArrayInputStream(text("/scenes/bob-dark.ttl").getBytes(StandardCharsets.UTF_8)),
            home);
  }

  private static String text(String resource) throws IOException {
    try (InputStream stream = AgendaCrashTest.class.getResourceAsStream(resource)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private MortalSite site(String name) {
    return new MortalSite(home, scene, directory.resolve(name));
  }

  /** Nobody is there for a minute, from half a minute after the start on. */
  private static void sleepWith(MortalSite site, String... goals) {
    site.begin(Integer.MAX_VALUE);
    site.clock.runUntil(site::allPresent, Duration.ofMinutes(1));
    List.of(goals).forEach(site::submit);
    site.clock.run(Duration.ofSeconds(30).minus(site.clock.now()));
    site.die();
    site.clock.run(Duration.ofMinutes(1));
    site.begin(Integer.MAX_VALUE);
  }

  @Test
  void whatWasMissedIsToldAndNotDoneAndWhatIsToComeIsDoneOnce() {
    try (MortalSite site = site("sleep")) {
      sleepWith(
          site,
          "(at \"00:01\" (>= (illuminance zone-a) 75))",
          "(at \"00:02\" (in rose zone-a))",
          "(at \"00:01\" :every \"day\" (in rose zone-a))");
      site.clock.runUntil(() -> site.outcomes.size() == 3, Duration.ofMinutes(3));

      GoalOutcome missed = site.outcomes.get("G1");
      assertThat(missed.reached()).isFalse();
      assertThat(missed.reasons())
          .containsExactly(
              "It was to be begun at 2026-01-01 00:01, when no platform ran; state it again if it"
                  + " is still wanted.");
      GoalOutcome done = site.outcomes.get("G2");
      assertThat(done.reached()).as(site.story.toString()).isTrue();
      assertThat(done.endedAt()).isGreaterThanOrEqualTo(Duration.ofMinutes(2));
      assertThat(site.goals())
          .anyMatch(
              goal ->
                  goal.contains("for 2026-01-02 00:01; missed: 2026-01-01 00:01")
                      && goal.contains("WAITING"));
      assertThat(site.witness.doneTwice(Set.of("move"))).isEmpty();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {LATER, ONCE})
  void someEntries(String goal) throws IOException {
    int entries = entries(goal);
    crash(goal, entries / 4, 0);
    crash(goal, entries / 2, 30);
  }

  @ParameterizedTest
  @ValueSource(strings = {LATER, ONCE})
  @Tag("full")
  void everyEntry(String goal) throws IOException {
    int entries = entries(goal);
    for (long at : Share.of(LongStream.rangeClosed(1, entries)).toArray()) {
      crash(goal, (int) at, 0);
      crash(goal, (int) at, (int) (1 + at % 60));
    }
  }

  private int entries(String goal) throws IOException {
    try (MortalSite site = site("whole")) {
      site.begin(Integer.MAX_VALUE);
      run(site, goal);
      assertThat(site.outcomes.get("G1").reached()).as(site.story.toString()).isTrue();
      return site.written();
    }
  }

  private static void run(MortalSite site, String goal) {
    site.clock.runUntil(() -> site.isDead() || site.allPresent(), Duration.ofMinutes(1));
    site.submit(goal);
    site.clock.runUntil(
        () -> site.isDead() || site.accepted.size() == 1 && site.allEnded(), Duration.ofMinutes(5));
  }

  /** Either it is done, once, or it is told that it was missed; what goes by what is so is not. */
  private void crash(String goal, int at, int torn) throws IOException {
    String name = "at-" + at + "-" + torn;
    try (MortalSite site = site(name)) {
      site.begin(at);
      run(site, goal);
      if (torn > 0) {
        site.tear(torn);
      }
      site.begin(Integer.MAX_VALUE);
      site.clock.runUntil(() -> site.allPresent() && site.allEnded(), Duration.ofMinutes(5));
      String context =
          "died at %d, torn by %d%n%s%n%s"
              .formatted(
                  at,
                  torn,
                  Files.readString(directory.resolve(name).resolve("journal.jsonl")),
                  site.story);
      assertThat(site.allEnded()).as(context).isTrue();
      assertThat(site.witness.executedTwice()).as(context).isEmpty();
      assertThat(site.goals().size()).as(context).isLessThanOrEqualTo(2);
      if (!site.accepted.isEmpty()) {
        GoalOutcome outcome = site.outcomes.get("G1");
        boolean isMissed =
            goal.equals(LATER) && outcome.reasons().toString().contains("no platform ran");
        assertThat(outcome.reached() || isMissed).as(context).isTrue();
      }
    }
  }
}
