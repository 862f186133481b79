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
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.agents.pulse.Condition;
import org.maestro.assembly.BusWitness;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.coordination.StoryEntry;
import org.maestro.launch.JavaProcess;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.AgentRow;
import org.maestro.platform.GoalReport;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.sim.SceneLoader;
import org.maestro.sl.SlParser;

/**
 * The process of the robot's agent is killed, or frozen and thawed, while the robot is at work for
 * Bob's cup: the goal is reached, no step is done twice, no agent is there twice (M78, A33, A34).
 */
@Isolated("its time is wall time, which others beside it would take")
class LostContainerTest {
  private static final double SPEED = 10;
  private static final String ROBOT = "rose";
  private static final Set<String> DEEDS = Set.of("pickUp", "placeAt");

  @TempDir Path directory;

  /** Platforms of one name in one process, one after the other, get into each other's way. */
  private String name = "";

  @Test
  void bobGetsHisCupThoughTheProcessOfTheRobotsAgentIsKilled() throws Exception {
    Measured measured = bobsCup(Disturbance.KILL);

    assertThat(measured.agentBackSeconds()).as("from the kill").isLessThan(3);
  }

  @Test
  void bobGetsHisCupThoughTheProcessOfTheRobotsAgentFreezesAndItJoinsAgainWhenItThaws()
      throws Exception {
    Measured measured = bobsCup(Disturbance.FREEZE);

    assertThat(measured.noticedSeconds()).isLessThan(5);
    assertThat(measured.agentBackSeconds() - measured.noticedSeconds()).isLessThan(3);
  }

  /** Ten runs of each; what was measured goes to the output. */
  @Tag("full")
  @RepeatedTest(10)
  void asOftenAsItHappens() throws Exception {
    for (Disturbance disturbance : Disturbance.values()) {
      Measured measured = bobsCup(disturbance);
      System.out.printf(
          "%s noticed %.2f s, agent back %.2f s, goal %.1f s%n",
          disturbance,
          measured.noticedSeconds(),
          measured.agentBackSeconds(),
          measured.goalSeconds());
      assertThat(measured.agentBackSeconds() - measured.noticedSeconds()).isLessThan(3);
    }
  }

  private enum Disturbance {
    KILL,
    FREEZE
  }

  /**
   * @param noticedSeconds from the disturbance until the container was known to be lost
   * @param agentBackSeconds from the disturbance until the robot had an agent again
   * @param goalSeconds simulated, from stating the goal
   */
  private record Measured(double noticedSeconds, double agentBackSeconds, double goalSeconds) {}

  private Measured bobsCup(Disturbance disturbance) throws Exception {
    name = "lost-" + Long.toString(System.nanoTime(), Character.MAX_RADIX);
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        LocalSite site = LocalSite.paced(settings(broker), SPEED);
        BusWitness witness = BusWitness.listen(new PahoTransport(broker.uri(), "witness"), name);
        JavaProcess robots = take(site)) {
      until(() -> robots.output().contains("The container robots runs here") || !robots.isAlive());
      assertThat(robots.isAlive()).as(robots::errors).isTrue();
      until(() -> site.platform().presentMembers().contains(ROBOT));
      ConcurrentLinkedQueue<StoryEntry> story = new ConcurrentLinkedQueue<>();
      CompletableFuture<Void> atWork = new CompletableFuture<>();
      site.platform()
          .onStory(
              entry -> {
                story.add(entry);
                if (entry.kind() == StoryEntry.Kind.STEP && entry.text().contains(" picks ")) {
                  atWork.complete(null);
                }
              });
      CompletableFuture<GoalReport> ended = new CompletableFuture<>();
      site.platform().pursue(SlParser.formula("(nextTo Cup Bob)"), id -> {}, ended::complete);
      until(atWork::isDone);

      long began = System.nanoTime();
      if (disturbance == Disturbance.KILL) {
        robots.kill();
      } else {
        robots.freeze();
      }
      until(() -> isLost(site));
      double noticed = secondsSince(began);
      until(() -> site.platform().presentMembers().contains(ROBOT));
      double back = secondsSince(began);
      until(ended::isDone);

      assertThat(ended.join().reached()).as(told(story)).isTrue();
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
      return new Measured(noticed, back, ended.join().duration().toMillis() / 1000.0);
    }
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
    Home home = new HomeLoader().load(text("/homes/bob.ttl"), "bob.ttl");
    return new SiteSettings(
        name,
        home,
        Optional.of(SceneLoader.load("bob-dark", resource("/scenes/bob-dark.ttl"), home)),
        1,
        Optional.of(broker.uri()),
        0,
        false,
        Optional.empty());
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
