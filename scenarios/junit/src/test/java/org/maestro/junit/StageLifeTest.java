package org.maestro.junit;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.ref.WeakReference;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.assembly.LocalSite;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.sim.world.World;

/** What a stage costs and leaves, measured without others beside it. */
@Isolated("counts the threads of the process")
class StageLifeTest {

  private static final Set<String> AGENTS =
      Set.of("CCA", "knowledge", "supervisor", "desk", "rose", "cam-a", "lamp-a1", "lux-a");

  /** Of each main container. */
  private static final Set<String> OF_JADE = Set.of("ams", "df");

  @MaestroTest(home = "bob", scene = "bob-dark")
  private static final class Dark {}

  @MaestroTest(home = "bob", scene = "bob-dark", clock = ClockKind.PACED, speed = 20)
  private static final class PacedDark {}

  @Test
  void theSameSeedTellsTheSameStory() {
    String first = story();

    assertThat(first).contains("Reached");
    assertThat(story()).isEqualTo(first);
  }

  @Test
  void theSecondStageIsSetWithinTwoSeconds() {
    stepped().close();
    long before = System.nanoTime();

    Stage second = stepped();

    long millis = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - before);
    second.close();
    assertThat(millis).isLessThan(2_000);
  }

  @Test
  void nothingIsLeftBehind() {
    Set<Thread> before = threads();
    try (EmbeddedBroker broker = EmbeddedBroker.start()) {
      List<WeakReference<World>> worlds = closedWorlds(broker);

      // JADE lets no container end that is younger than three seconds.
      Awaitility.await()
          .atMost(Duration.ofSeconds(20))
          .untilAsserted(
              () -> {
                assertThat(threads()).isSubsetOf(before);
                System.gc();
                assertThat(worlds).as("memory").allMatch(world -> world.get() == null);
              });
    }
  }

  /** A method of its own, as a frame holds what stands in it. */
  private static List<WeakReference<World>> closedWorlds(EmbeddedBroker broker) {
    try (Stage stepped = stepped();
        Stage paced = paced(broker)) {
      assertThat(ourThreads()).contains("CCA", "rose").anyMatch(name -> name.contains("paceddark"));
      return List.of(new WeakReference<>(stepped.world()), new WeakReference<>(paced.world()));
    }
  }

  private static Set<Thread> threads() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> OF_JADE.contains(thread.getName()) || isOurs(thread.getName()))
        .collect(Collectors.toSet());
  }

  /** Those of agents, clocks, closing containers, and of connections to the bus. */
  private static Set<String> ourThreads() {
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .filter(StageLifeTest::isOurs)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private static boolean isOurs(String thread) {
    return AGENTS.contains(thread)
        || thread.toLowerCase(Locale.ROOT).contains("maestro")
        || thread.contains("paceddark");
  }

  private static String story() {
    try (Stage stage = stepped()) {
      return stage.goal("(nextTo Cup Bob)").storyText();
    }
  }

  private static Stage stepped() {
    return new Stage(
        LocalSite.stepped(wanted(Dark.class).settings(Optional.empty())), Duration.ofMinutes(10));
  }

  private static Stage paced(EmbeddedBroker broker) {
    return new Stage(
        LocalSite.paced(wanted(PacedDark.class).settings(Optional.of(broker.uri())), 20),
        Duration.ofMinutes(10));
  }

  private static SiteWanted wanted(Class<?> like) {
    return new SiteWanted(like, like.getAnnotation(MaestroTest.class));
  }
}
