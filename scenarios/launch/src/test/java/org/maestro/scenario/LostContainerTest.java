package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.agents.content.GoalReport;
import org.maestro.agents.pulse.Condition;
import org.maestro.assembly.BusWitness;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.launch.JavaProcess;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.AgentRow;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sl.SlParser;

/**
 * The process of the robot's agent is killed, or frozen and thawed, while the robot is at work for
 * Bob's cup: the goal is reached, no step is done twice, no agent is there twice (M78, A33, A34).
 * How long that takes is measured by {@code ./maestro bench losses}.
 */
@Isolated("its time is wall time, which others beside it would take")
class LostContainerTest {
  private static final double SPEED = 10;

  /** Slow enough for the goal to outlast the process's awakening. */
  private static final double SPEED_TO_THAW_IN = 2;

  private static final String ROBOT = "rose";
  private static final Set<String> DEEDS = Set.of("move", "pick", "place");

  @TempDir Path directory;

  /** Platforms of one name in one process, one after the other, get into each other's way. */
  private String name = "";

  private String needs = "";

  /** What JADE has for a whole process goes with its last platform, also while another begins. */
  @BeforeEach
  void formerPlatformsHaveEnded() {
    until(
        () ->
            Thread.getAllStackTraces().keySet().stream()
                .noneMatch(thread -> thread.getName().equals("maestro-container-end")));
  }

  @Test
  @Tag("full")
  void bobGetsHisCupThoughTheProcessOfTheRobotsAgentIsKilled() throws Exception {
    bobsCup(Disturbance.KILL);
  }

  @Test
  void bobGetsHisCupThoughTheProcessOfTheRobotsAgentFreezesAndItJoinsAgainWhenItThaws()
      throws Exception {
    bobsCup(Disturbance.FREEZE);
  }

  /**
   * The process comes to life again while the robot's other agent is at work: what the one there
   * had is none of its business any more.
   */
  @Test
  @Tag("full")
  void bobGetsHisCupThoughTheFrozenProcessThawsMeanwhile() throws Exception {
    name = "thawed-" + Long.toString(System.nanoTime(), Character.MAX_RADIX);
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        LocalSite site = LocalSite.paced(settings(broker), SPEED_TO_THAW_IN);
        BusWitness witness = BusWitness.listen(new PahoTransport(broker.uri(), "witness"), name);
        JavaProcess robots = take(site)) {
      until(() -> robots.output().contains("The container robots runs here") || !robots.isAlive());
      until(() -> site.platform().presentMembers().contains(ROBOT));
      Pursued pursued = pursue(site);
      until(pursued.atWork()::isDone);
      robots.freeze();
      until(() -> isLost(site));
      until(() -> site.platform().presentMembers().contains(ROBOT));
      robots.thaw();
      until(pursued.ended()::isDone);
      String story = told(pursued.story());
      assertThat(pursued.ended().join().reached()).as(story).isTrue();
      assertThat(story).doesNotContain("has lost its agent");
      until(() -> robots.output().contains("it joins again"));
      until(() -> site.platform().presentMembers().contains(ROBOT));
      assertThat(witness.executedTwice()).isEmpty();
      assertThat(witness.doneTwice(DEEDS)).isEmpty();
    }
  }

  /**
   * Three hosts: the platform's own does not fit, of two that do one dies, then the other (ADE,
   * 3.2; A37).
   */
  @Test
  @Tag("full")
  void anAgentThatNeedsMoreThanTheOwnProcessHasGoesFromHostToHost() throws Exception {
    name = "hosts-" + Long.toString(System.nanoTime(), Character.MAX_RADIX);
    needs = "maestro:hostNeeds \"radio\" ;";
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        LocalSite site = LocalSite.paced(settings(broker), SPEED);
        BusWitness witness = BusWitness.listen(new PahoTransport(broker.uri(), "witness"), name)) {
      assertThat(site.platform().homeless()).containsExactly(ROBOT);
      try (JavaProcess attic = host(site, "attic", "radio,memory 512");
          JavaProcess cellar = host(site, "cellar", "radio");
          JavaProcess shed = host(site, "shed", "lamp")) {
        for (JavaProcess host : List.of(attic, cellar, shed)) {
          until(() -> host.output().contains("It provides ") || !host.isAlive());
          assertThat(host.isAlive()).as(host::errors).isTrue();
        }
        until(() -> site.platform().presentMembers().contains(ROBOT));
        String first = placeOf(site);
        assertThat(first).isIn("attic", "cellar");
        Pursued pursued = pursue(site);
        until(pursued.atWork()::isDone);

        (first.equals("attic") ? attic : cellar).kill();
        until(() -> !placeOf(site).equals(first));
        until(() -> site.platform().presentMembers().contains(ROBOT));
        until(pursued.ended()::isDone);
        assertThat(pursued.ended().join().reached()).as(told(pursued.story())).isTrue();
        assertThat(witness.executedTwice()).isEmpty();
        assertThat(witness.doneTwice(DEEDS)).isEmpty();

        (first.equals("attic") ? cellar : attic).kill();
        until(() -> site.platform().homeless().contains(ROBOT));
        Pursued nobody = pursue(site, "(in %s zone-b)".formatted(ROBOT));
        until(nobody.ended()::isDone);
        assertThat(String.join(" ", nobody.ended().join().reasons())).contains("needs radio");
      }
      try (JavaProcess loft = host(site, "loft", "radio")) {
        until(() -> site.platform().presentMembers().contains(ROBOT));
        assertThat(placeOf(site)).isEqualTo("loft");
        assertThat(loft.isAlive()).isTrue();
      }
    }
  }

  /** Its thread is stopped, which Java can do up to 19; at the end it comes to life again. */
  @Test
  @Tag("full")
  @EnabledForJreRange(max = JRE.JAVA_19)
  @SuppressWarnings("removal")
  void anAgentThatHangsIsReplacedAndDoesNothingWhenItComesToLifeAgain() throws Exception {
    name = "hung-" + Long.toString(System.nanoTime(), Character.MAX_RADIX);
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        LocalSite site = LocalSite.paced(settings(broker), SPEED);
        BusWitness witness = BusWitness.listen(new PahoTransport(broker.uri(), "witness"), name)) {
      Thread hung = threadsOf(ROBOT).get(0);
      Pursued pursued = pursue(site);
      until(pursued.atWork()::isDone);
      until(() -> hung.getState() == Thread.State.WAITING);
      long began = System.nanoTime();
      hung.suspend();
      try {
        until(() -> threadsOf(ROBOT).size() == 2);
        System.out.printf("agent hung, another begun after %.2f s%n", secondsSince(began));
        until(pursued.ended()::isDone);
        assertThat(pursued.ended().join().reached()).as(told(pursued.story())).isTrue();
      } finally {
        hung.resume();
      }
      until(
          () ->
              Arrays.stream(hung.getStackTrace())
                  .anyMatch(frame -> frame.getMethodName().equals("takeDown")));
      Pursued again = pursue(site, "(in %s zone-a)".formatted(ROBOT));
      until(again.ended()::isDone);
      assertThat(again.ended().join().reached()).as(told(again.story())).isTrue();
      assertThat(site.platform().directory().find(ROBOT)).isPresent();
      assertThat(witness.executedTwice()).isEmpty();
      assertThat(witness.doneTwice(DEEDS)).isEmpty();
    }
  }

  private static List<Thread> threadsOf(String agent) {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().equals(agent))
        .toList();
  }

  private static String placeOf(LocalSite site) {
    return site.platform().agents().stream()
        .filter(row -> row.agent().equals(ROBOT))
        .map(AgentRow::container)
        .findFirst()
        .orElse("");
  }

  private JavaProcess host(LocalSite site, String host, String provides) throws IOException {
    return JavaProcess.start(
        "org.maestro.launch.Maestro",
        List.of(
            "container",
            "--main",
            "127.0.0.1:" + site.platform().port(),
            "--name",
            host,
            "--provides",
            provides),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }

  private enum Disturbance {
    KILL,
    FREEZE
  }

  private void bobsCup(Disturbance disturbance) throws Exception {
    name = "lost-" + Long.toString(System.nanoTime(), Character.MAX_RADIX);
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        LocalSite site = LocalSite.paced(settings(broker), SPEED);
        BusWitness witness = BusWitness.listen(new PahoTransport(broker.uri(), "witness"), name);
        JavaProcess robots = take(site)) {
      until(() -> robots.output().contains("The container robots runs here") || !robots.isAlive());
      assertThat(robots.isAlive()).as(robots::errors).isTrue();
      until(() -> site.platform().presentMembers().contains(ROBOT));
      Pursued pursued = pursue(site);
      CompletableFuture<GoalReport> ended = pursued.ended();
      until(pursued.atWork()::isDone);

      switch (disturbance) {
        case KILL -> robots.kill();
        case FREEZE -> robots.freeze();
      }
      until(() -> isLost(site));
      until(() -> site.platform().presentMembers().contains(ROBOT));
      until(ended::isDone);

      assertThat(ended.join().reached()).as(told(pursued.story())).isTrue();
      if (disturbance == Disturbance.FREEZE) {
        robots.thaw();
        until(() -> robots.output().contains("it joins again"));
        until(
            () ->
                site.platform().containers().get("robots") == Condition.ALIVE
                    && !site.platform().topics().contains("robots"));
        until(() -> site.platform().presentMembers().contains(ROBOT));
      }
      assertThat(site.platform().agents())
          .extracting(AgentRow::agent)
          .doesNotHaveDuplicates()
          .contains(ROBOT);
      assertThat(witness.executedTwice()).isEmpty();
      assertThat(witness.doneTwice(DEEDS)).isEmpty();
    }
  }

  /** A goal and what is known of it. */
  private record Pursued(
      Queue<StoryEntry> story,
      CompletableFuture<Void> atWork,
      CompletableFuture<GoalReport> ended) {}

  private static Pursued pursue(LocalSite site) {
    return pursue(site, "(nextTo Cup Bob)");
  }

  private static Pursued pursue(LocalSite site, String goal) {
    Pursued pursued =
        new Pursued(
            new ConcurrentLinkedQueue<>(), new CompletableFuture<>(), new CompletableFuture<>());
    site.platform()
        .onStory(
            entry -> {
              pursued.story().add(entry);
              if (entry.kind() == StoryEntry.Kind.STEP && entry.text().contains(" picks ")) {
                pursued.atWork().complete(null);
              }
            });
    site.platform().desk().pursue(SlParser.formula(goal), id -> {}, pursued.ended()::complete);
    return pursued;
  }

  /** The container of the other process is lost, or one of this process has taken its name. */
  private static boolean isLost(LocalSite site) {
    Condition now = site.platform().containers().get("robots");
    return now == null || now == Condition.LOST || site.platform().topics().contains("robots");
  }

  private static InputStream resource(String path) {
    return new ByteArrayInputStream(text(path).getBytes(StandardCharsets.UTF_8));
  }

  private static String text(String path) {
    try (InputStream turtle = LostContainerTest.class.getResourceAsStream(path)) {
      return new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private SiteSettings settings(EmbeddedBroker broker) {
    Home home =
        new HomeLoader()
            .load(
                text("/homes/bob.ttl")
                    .replace("home:rose a :MobileRobot ;", "home:rose a :MobileRobot ; " + needs),
                "bob.ttl");
    return SiteSettings.of(name, home)
        .scene(SceneLoader.load("bob-dark", resource("/scenes/bob-dark.ttl"), home))
        .broker(broker.uri())
        .build();
  }

  private JavaProcess take(LocalSite site) throws IOException {
    return JavaProcess.start(
        "org.maestro.launch.Maestro",
        List.of("container", "--main", "127.0.0.1:" + site.platform().port(), "--name", "robots"),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }

  private static String told(Iterable<StoryEntry> story) {
    StringBuilder told = new StringBuilder();
    story.forEach(entry -> told.append(entry.at()).append(' ').append(entry.text()).append('\n'));
    return told.toString();
  }

  private static double secondsSince(long nanos) {
    return (System.nanoTime() - nanos) / 1e9;
  }

  private static void until(BooleanSupplier condition) {
    await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(10))
        .atMost(Duration.ofSeconds(90))
        .until(condition::getAsBoolean);
  }
}
