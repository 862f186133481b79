package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
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
import org.maestro.platform.Premises;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.sim.SceneLoader;
import org.maestro.sl.SlParser;

/**
 * Bob's cup with agents on hosts that have addresses of their own: a host is killed, freezes, is
 * cut off for ten seconds, or is slow, and all hosts but the platform's own are lost (A18, A33,
 * A34, A37). The goal is reached, no agent is there twice, and no step is done twice. How often
 * each is run is told by the property {@code maestro.hosts.runs}; what was measured goes to the
 * output.
 */
@Tag("full")
@Isolated("its time is wall time, which others beside it would take")
class HostsTest {
  private static final double SPEED = 10;
  private static final String ROBOT = "rose";
  private static final Set<String> DEEDS = Set.of("pickUp", "placeAt");
  private static final Duration CUT = Duration.ofSeconds(10);
  private static final Duration SLOW = Duration.ofMillis(50);

  @TempDir Path directory;

  private enum Disturbance {
    NONE,
    KILL,
    FREEZE,
    CUT,
    SLOW,
    ALL_BUT_ONE
  }

  /**
   * @param noticedSeconds from the disturbance until the container was known to be lost
   * @param backSeconds from then until the robot had an agent again
   * @param goalSeconds simulated, from stating the goal
   */
  private record Measured(double noticedSeconds, double backSeconds, double goalSeconds) {}

  /** What JADE has for a whole process goes with its last platform, also while another begins. */
  @BeforeEach
  void formerPlatformsHaveEnded() {
    until(
        () ->
            Thread.getAllStackTraces().keySet().stream()
                .noneMatch(thread -> thread.getName().equals("maestro-container-end")));
  }

  @ParameterizedTest
  @EnumSource(Disturbance.class)
  void bobGetsHisCup(Disturbance disturbance) throws Exception {
    boolean areHosts = NetworkHosts.areThere();
    if (!areHosts) {
      System.out.println(
          "No network namespaces can be made here: hosts are processes on loopback, and no link is cut or slowed.");
      Assumptions.assumeFalse(
          disturbance == Disturbance.CUT || disturbance == Disturbance.SLOW,
          "links of loopback cannot be cut");
    }
    List<Measured> all = new ArrayList<>();
    for (int run = 0; run < Integer.getInteger("maestro.hosts.runs", 1); run++) {
      Measured measured = areHosts ? onHosts(disturbance) : onLoopback(disturbance);
      all.add(measured);
      System.out.printf(
          Locale.ROOT,
          "%s, run %d: reached; noticed after %.2f s, agent back %.2f s later, goal in %.1f simulated s%n",
          disturbance,
          run + 1,
          measured.noticedSeconds(),
          measured.backSeconds(),
          measured.goalSeconds());
    }
    if (disturbance == Disturbance.KILL || disturbance == Disturbance.FREEZE) {
      assertThat(all).allMatch(measured -> measured.noticedSeconds() < 5);
      assertThat(all).allMatch(measured -> measured.backSeconds() < 3);
    }
  }

  private Measured onHosts(Disturbance disturbance) throws Exception {
    try (NetworkHosts network = NetworkHosts.open();
        EmbeddedBroker broker = EmbeddedBroker.start();
        Relay relay = Relay.listen(network.address(), broker.uri())) {
      return run(disturbance, broker, Optional.of(network), relay);
    }
  }

  private Measured onLoopback(Disturbance disturbance) throws Exception {
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        Relay relay = Relay.listen("127.0.0.1", broker.uri())) {
      return run(disturbance, broker, Optional.empty(), relay);
    }
  }

  private Measured run(
      Disturbance disturbance, EmbeddedBroker broker, Optional<NetworkHosts> network, Relay relay)
      throws Exception {
    String name = "hosts-" + Long.toString(System.nanoTime(), Character.MAX_RADIX);
    String address = network.map(NetworkHosts::address).orElse("127.0.0.1");
    List<String> attic = network.map(hosts -> hosts.add("attic")).orElse(List.of());
    List<String> cellar = network.map(hosts -> hosts.add("cellar")).orElse(List.of());
    try (LocalSite site = LocalSite.paced(settings(name, relay, address), SPEED);
        BusWitness witness = BusWitness.listen(new PahoTransport(broker.uri(), "witness"), name);
        JavaProcess robots = container(attic, site, address, "robots");
        JavaProcess lights = container(cellar, site, address, "lights")) {
      for (JavaProcess host : List.of(robots, lights)) {
        until(() -> host.output().contains(" runs here") || !host.isAlive());
        assertThat(host.isAlive()).as(host::errors).isTrue();
      }
      until(() -> site.platform().presentMembers().containsAll(Set.of(ROBOT, "lamp-b1")));
      if (disturbance == Disturbance.SLOW) {
        network.orElseThrow().slow("attic", "1mbit");
        relay.delay(SLOW);
      }
      Queue<StoryEntry> story = new ConcurrentLinkedQueue<>();
      CompletableFuture<Void> atWork = new CompletableFuture<>();
      CompletableFuture<GoalReport> ended = new CompletableFuture<>();
      site.platform()
          .onStory(
              entry -> {
                story.add(entry);
                if (entry.kind() == StoryEntry.Kind.STEP && entry.text().contains(" picks ")) {
                  atWork.complete(null);
                }
              });
      site.platform().pursue(SlParser.formula("(nextTo Cup Bob)"), id -> {}, ended::complete);
      until(() -> atWork.isDone() || ended.isDone());

      long began = System.nanoTime();
      switch (disturbance) {
        case KILL -> robots.kill();
        case FREEZE -> robots.freeze();
        case CUT -> network.orElseThrow().cut("attic");
        case ALL_BUT_ONE -> {
          robots.kill();
          lights.kill();
        }
        case NONE, SLOW -> {
          // Nobody is lost.
        }
      }
      boolean isLost = disturbance != Disturbance.NONE && disturbance != Disturbance.SLOW;
      double noticed = 0;
      double back = 0;
      if (isLost) {
        until(() -> isLost(site, "robots"));
        noticed = seconds(began);
        until(() -> site.platform().presentMembers().contains(ROBOT));
        back = seconds(began) - noticed;
      }
      if (disturbance == Disturbance.CUT) {
        until(() -> seconds(began) > CUT.toMillis() / 1000.0);
        network.orElseThrow().heal("attic");
      }
      until(ended::isDone);
      assertThat(ended.join().reached()).as(told(story)).isTrue();
      if (disturbance == Disturbance.FREEZE) {
        robots.thaw();
      }
      if (disturbance == Disturbance.FREEZE || disturbance == Disturbance.CUT) {
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
          .contains(ROBOT, "lamp-b1");
      assertThat(witness.executedTwice()).as(told(story)).isEmpty();
      assertThat(witness.doneTwice(DEEDS)).as(told(story)).isEmpty();
      return new Measured(noticed, back, ended.join().duration().toMillis() / 1000.0);
    }
  }

  /** The container of the other process is lost, or one of this process has taken its name. */
  private static boolean isLost(LocalSite site, String container) {
    Condition now = site.platform().containers().get(container);
    return now == null || now == Condition.LOST || site.platform().topics().contains(container);
  }

  private JavaProcess container(
      List<String> before, LocalSite site, String address, String container) throws IOException {
    return JavaProcess.start(
        before,
        "org.maestro.launch.Maestro",
        List.of("container", "--main", address + ":" + site.platform().port(), "--name", container),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }

  private static SiteSettings settings(String name, Relay relay, String address) {
    Home home = new HomeLoader().load(text("/homes/bob.ttl"), "bob.ttl");
    return new SiteSettings(
            name,
            home,
            Optional.of(
                SceneLoader.load(
                    "bob-dark",
                    new ByteArrayInputStream(
                        text("/scenes/bob-dark.ttl").getBytes(StandardCharsets.UTF_8)),
                    home)),
            1,
            Optional.of(relay.uri()),
            0,
            false,
            Optional.empty())
        .at(Premises.usual().on(address));
  }

  private static String text(String path) {
    try (var turtle = HostsTest.class.getResourceAsStream(path)) {
      return new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String told(Iterable<StoryEntry> story) {
    StringBuilder told = new StringBuilder();
    story.forEach(entry -> told.append(entry.at()).append(' ').append(entry.text()).append('\n'));
    return told.toString();
  }

  private static double seconds(long sinceNanos) {
    return (System.nanoTime() - sinceNanos) / 1e9;
  }

  private static void until(BooleanSupplier condition) {
    await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(10))
        .atMost(Duration.ofSeconds(90))
        .until(condition::getAsBoolean);
  }
}
