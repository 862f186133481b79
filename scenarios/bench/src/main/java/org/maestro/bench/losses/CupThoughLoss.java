package org.maestro.bench.losses;

import static org.maestro.bench.Waiting.secondsSince;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.maestro.agents.content.GoalReport;
import org.maestro.agents.pulse.Condition;
import org.maestro.assembly.BusWitness;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.bench.MaestroProcess;
import org.maestro.bench.Waiting;
import org.maestro.bench.losses.LossesBench.Figure;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.AgentRow;
import org.maestro.platform.jade.Premises;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sl.SlParser;

/**
 * Bob's cup, with the agents of the robot and of the lights on two hosts of their own; when the
 * robot is at work something is lost. For one thread.
 */
final class CupThoughLoss {
  private static final double SPEED = 10;
  private static final String ROBOT = "rose";
  private static final String LAMP = "lamp-b1";
  private static final String GOAL = "(nextTo Cup Bob)";
  private static final Set<String> DEEDS = Set.of("move", "pick", "place");
  private static final Duration CUT = Duration.ofSeconds(10);
  private static final Duration SLOW = Duration.ofMillis(50);

  private final Loss loss;
  private final Queue<StoryEntry> story = new ConcurrentLinkedQueue<>();
  private final CompletableFuture<Void> atWork = new CompletableFuture<>();
  private final CompletableFuture<GoalReport> ended = new CompletableFuture<>();
  private final Map<Figure, Double> figures = new EnumMap<>(Figure.class);

  CupThoughLoss(Loss loss) {
    this.loss = loss;
  }

  /**
   * To be called once.
   *
   * @param areHosts whether hosts can have addresses of their own; else they are processes
   * @throws IllegalStateException when what has to be is not so
   */
  Map<Figure, Double> run(boolean areHosts) {
    Waiting.formerPlatformsHaveEnded();
    if (!areHosts) {
      return run(Optional.empty());
    }
    try (NetworkHosts network = NetworkHosts.open()) {
      return run(Optional.of(network));
    }
  }

  private Map<Figure, Double> run(Optional<NetworkHosts> network) {
    String name = "losses-" + Long.toString(System.nanoTime(), Character.MAX_RADIX);
    String address = network.map(NetworkHosts::address).orElse("127.0.0.1");
    List<String> attic = network.map(hosts -> hosts.add("attic")).orElse(List.of());
    List<String> cellar = network.map(hosts -> hosts.add("cellar")).orElse(List.of());
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        Relay relay = Relay.listen(address, broker.uri());
        LocalSite site = LocalSite.paced(settings(name, relay, address), SPEED);
        BusWitness witness = BusWitness.listen(new PahoTransport(broker.uri(), "witness"), name);
        MaestroProcess robots = container(attic, site, address, "robots");
        MaestroProcess lights = container(cellar, site, address, "lights")) {
      robots.awaitSaying(" runs here");
      lights.awaitSaying(" runs here");
      Waiting.until(
          () -> site.platform().presentMembers().containsAll(Set.of(ROBOT, LAMP)),
          "the agents are back");
      if (loss == Loss.SLOW) {
        network.orElseThrow().slow("attic", "1mbit");
        relay.delay(SLOW);
      }
      pursue(site);
      long began = System.nanoTime();
      lose(network, robots, lights);
      if (loss.isOfContainers()) {
        measureReturn(site, began);
      }
      if (loss == Loss.CUT) {
        Waiting.until(() -> secondsSince(began) > CUT.toSeconds(), "the link is healed");
        network.orElseThrow().heal("attic");
      }
      Waiting.until(ended::isDone, "the goal's end: " + told());
      require(ended.join().reached(), "the goal is reached");
      figures.put(Figure.GOAL, ended.join().duration().toMillis() / 1000.0);
      if (loss == Loss.FROZEN) {
        robots.thaw();
      }
      if (loss == Loss.FROZEN || loss == Loss.CUT) {
        awaitReturn(site, robots);
      }
      check(site, witness);
      return figures;
    }
  }

  private void pursue(LocalSite site) {
    site.platform()
        .onStory(
            entry -> {
              story.add(entry);
              if (entry.kind() == StoryEntry.Kind.STEP && entry.text().contains(" picks ")) {
                atWork.complete(null);
              }
            });
    site.platform().desk().pursue(SlParser.formula(GOAL), id -> {}, ended::complete);
    Waiting.until(() -> atWork.isDone() || ended.isDone(), "the robot is at work");
  }

  private void lose(Optional<NetworkHosts> network, MaestroProcess robots, MaestroProcess lights) {
    switch (loss) {
      case KILLED -> robots.kill();
      case FROZEN -> robots.freeze();
      case CUT -> network.orElseThrow().cut("attic");
      case ALL_BUT_ONE -> {
        robots.kill();
        lights.kill();
      }
      default -> require(robots.isAlive() && lights.isAlive(), "nobody is lost");
    }
  }

  private void measureReturn(LocalSite site, long began) {
    Waiting.until(() -> isLost(site), "the loss is noticed");
    figures.put(Figure.NOTICED, secondsSince(began));
    long noticed = System.nanoTime();
    Waiting.until(
        () -> site.platform().presentMembers().contains(ROBOT), "the robot has an agent again");
    figures.put(Figure.BACK, secondsSince(noticed));
  }

  /** The container is lost, or one of this process has taken its name. */
  private static boolean isLost(LocalSite site) {
    Condition now = site.platform().containers().get("robots");
    return now == null || now == Condition.LOST || site.platform().topics().contains("robots");
  }

  private static void awaitReturn(LocalSite site, MaestroProcess robots) {
    robots.awaitSaying("it joins again");
    Waiting.until(
        () ->
            site.platform().containers().get("robots") == Condition.ALIVE
                && !site.platform().topics().contains("robots"),
        "the container is back");
    Waiting.until(
        () -> site.platform().presentMembers().contains(ROBOT), "the robot's agent is back there");
  }

  private void check(LocalSite site, BusWitness witness) {
    List<String> agents = site.platform().agents().stream().map(AgentRow::agent).toList();
    require(agents.containsAll(Set.of(ROBOT, LAMP)), "all agents are there");
    require(agents.size() == Set.copyOf(agents).size(), "no agent is there twice");
    require(witness.executedTwice().isEmpty(), "no call is executed twice");
    require(witness.doneTwice(DEEDS).isEmpty(), "no step is done twice");
  }

  private void require(boolean isSo, String what) {
    if (!isSo) {
      throw new IllegalStateException(
          "Lost was %s, and it is not so that %s:%n%s".formatted(loss.inWords(), what, told()));
    }
  }

  private String told() {
    StringBuilder told = new StringBuilder();
    story.forEach(entry -> told.append(entry.at()).append(' ').append(entry.text()).append('\n'));
    return told.toString();
  }

  private static MaestroProcess container(
      List<String> before, LocalSite site, String address, String container) {
    return MaestroProcess.start(
        before,
        List.of(
            "container", "--main", address + ":" + site.platform().port(), "--name", container));
  }

  private static SiteSettings settings(String name, Relay relay, String address) {
    Home home = new HomeLoader().load(text("/homes/bob.ttl"), "bob.ttl");
    ByteArrayInputStream scene =
        new ByteArrayInputStream(text("/scenes/bob-dark.ttl").getBytes(StandardCharsets.UTF_8));
    return SiteSettings.of(name, home)
        .scene(SceneLoader.load("bob-dark", scene, home))
        .broker(relay.uri())
        .premises(Premises.usual().on(address))
        .build();
  }

  private static String text(String path) {
    try (var turtle = CupThoughLoss.class.getResourceAsStream(path)) {
      return new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
