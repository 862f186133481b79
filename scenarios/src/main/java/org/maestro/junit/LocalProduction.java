package org.maestro.junit;

import java.io.ByteArrayInputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Home;
import org.maestro.planning.OptimalPlanner;
import org.maestro.platform.MaestroPlatform;
import org.maestro.platform.PlatformSettings;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Transport;
import org.maestro.sim.Scene;
import org.maestro.sim.SceneLoader;
import org.maestro.sim.SimulatedHome;
import org.maestro.sim.World;

/** Platform, bus and simulated devices in this process. */
final class LocalProduction implements Production {

  private static final Duration STEPPED_DECISION = Duration.ofMillis(100);
  private static final Duration OPENING = Duration.ofSeconds(60);
  private static final String CONTROLLER = "maestro";

  /** Runs time until the condition holds, and says whether it does. */
  private interface Driver {
    boolean runUntil(BooleanSupplier condition, Duration limit);
  }

  private final Clock clock;
  private final Driver driver;
  private final Deque<AutoCloseable> parts = new ArrayDeque<>();
  private final SimulatedHome simulated;
  private final MaestroPlatform platform;

  private LocalProduction(
      Site site,
      String siteName,
      Clock clock,
      Driver driver,
      Duration decisionTime,
      Function<String, Transport> transports,
      Optional<URI> broker) {
    this.clock = clock;
    this.driver = driver;
    Home home = site.home();
    Scene scene =
        SceneLoader.load(
            site.sceneResource(),
            new ByteArrayInputStream(
                site.text(site.sceneResource()).getBytes(StandardCharsets.UTF_8)),
            home);
    this.simulated =
        opened(
            SimulatedHome.start(
                new SimulatedHome.Setup(
                    home,
                    scene,
                    clock,
                    site.wanted().seed(),
                    transports,
                    siteName,
                    new DescriptionWriter(home)::write)));
    BusLink link =
        opened(BusLink.connect(CONTROLLER, siteName, transports.apply(CONTROLLER), clock));
    this.platform =
        opened(
            MaestroPlatform.start(
                new PlatformSettings(
                    siteName,
                    0,
                    false,
                    broker.map(URI::toString),
                    siteName,
                    decisionTime,
                    Optional.empty()),
                new CollectiveKnowledge(home, clock),
                new OptimalPlanner(),
                link,
                clock,
                new DescriptionReader(home.vocabulary())::read));
    awaitMembers();
  }

  static LocalProduction stepped(Site site) {
    SteppedClock clock = new SteppedClock();
    InProcessBus bus = new InProcessBus(clock);
    return new LocalProduction(
        site,
        site.uniqueName(),
        clock,
        clock::runUntil,
        STEPPED_DECISION,
        bus::client,
        Optional.empty());
  }

  static LocalProduction paced(Site site, SharedBroker broker, double speed) {
    PacedClock clock = new PacedClock(speed);
    String name = site.uniqueName();
    LocalProduction production =
        new LocalProduction(
            site,
            name,
            clock,
            (condition, limit) -> poll(clock, condition, limit),
            Duration.ZERO,
            id -> new PahoTransport(broker.uri(), name + "-" + id),
            Optional.of(broker.uri()));
    production.parts.addLast(clock);
    return production;
  }

  @Override
  public MaestroPlatform platform() {
    return platform;
  }

  @Override
  public Clock clock() {
    return clock;
  }

  @Override
  public World world() {
    return simulated.world();
  }

  @Override
  public boolean runUntil(BooleanSupplier condition, Duration limit) {
    return driver.runUntil(condition, limit);
  }

  @Override
  public void kill(String device) {
    world().die(device);
  }

  @Override
  public void revive(String device) {
    world().revive(device);
  }

  /** Latest first; one that cannot be closed does not keep the others open. */
  @Override
  public void close() {
    StageException failure = null;
    for (AutoCloseable part : parts) {
      try {
        part.close();
      } catch (Exception e) {
        failure = new StageException("The stage could not be cleared: " + e.getMessage(), e);
      }
    }
    if (failure != null) {
      throw failure;
    }
  }

  private void awaitMembers() {
    boolean complete =
        runUntil(
            () ->
                simulated.devices().stream()
                    .filter(world()::isAlive)
                    .allMatch(id -> platform.presentMembers().contains(id)),
            OPENING);
    if (!complete) {
      String here = String.join(", ", platform.presentMembers());
      close();
      throw new StageException(
          "Within " + OPENING + " only these members were ready: " + here + ".");
    }
  }

  private <T extends AutoCloseable> T opened(T part) {
    parts.addFirst(part);
    return part;
  }

  private static boolean poll(Clock clock, BooleanSupplier condition, Duration limit) {
    Duration end = clock.now().plus(limit);
    while (!condition.getAsBoolean()) {
      if (clock.now().compareTo(end) >= 0) {
        return false;
      }
      LockSupport.parkNanos(1_000_000);
    }
    return true;
  }
}
