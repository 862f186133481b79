package org.maestro.assembly;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URI;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.KnowledgeSettings;
import org.maestro.knowledge.calibration.CalibratedKnowledge;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Home;
import org.maestro.planning.ObjectivePlanner;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.ReplanningPlanner;
import org.maestro.platform.MaestroPlatform;
import org.maestro.platform.PlatformServices;
import org.maestro.platform.PlatformSettings;
import org.maestro.platform.failover.OtherNames;
import org.maestro.platform.guard.Guard;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.link.SiteKind;
import org.maestro.rats.member.CallPolicy;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.SharedConnection;
import org.maestro.rats.transport.Transport;
import org.maestro.sim.SimulatedHome;
import org.maestro.sim.world.World;

/**
 * A running site of this process. Closing it leaves nothing behind. For the thread that started it.
 */
public final class LocalSite implements AutoCloseable {
  private static final Duration DECISION_ON_STEPPED_CLOCK = Duration.ofMillis(20);
  private static final Duration STEPPED_OPENING = Duration.ofSeconds(60);

  /** Wall time, which is what the opening of a site on the real bus takes. */
  private static final Duration PACED_OPENING = Duration.ofSeconds(20);

  private static final Duration OPENING_OF_A_DEVICE = Duration.ofMillis(50);

  /** More names than these say no more. */
  private static final int MOST_NAMES = 10;

  private static final int BROKER_ANSWERS_WITHIN_MILLIS = 2_000;
  private static final String CONTROLLER = "maestro";

  /** Who only listens to the bus; a secured site has a user of that name. */
  public static final String OBSERVER = "observer";

  /**
   * Lets time pass until a condition holds, for a simulated time at most; says whether it holds.
   */
  private interface Driver {
    boolean runUntil(BooleanSupplier condition, Duration limit);
  }

  private final OpenParts parts = new OpenParts();
  private final SiteSettings settings;
  private final Clock clock;
  private final Driver driver;
  private final Optional<URI> broker;
  private final Function<String, Transport> transports;
  private final Function<String, Transport> membersTransports;
  private Optional<SimulatedHome> simulated = Optional.empty();
  private Optional<InProcessBus> bus = Optional.empty();
  private CallPolicy policy = CallPolicy.OPEN;
  private SiteKind kind = SiteKind.OPEN;
  private Optional<MaestroPlatform> platform = Optional.empty();

  private LocalSite(
      SiteSettings settings,
      Clock clock,
      Driver driver,
      Optional<URI> broker,
      Function<String, Transport> transports,
      Function<String, Transport> membersTransports) {
    this.settings = settings;
    this.clock = clock;
    this.driver = driver;
    this.broker = broker;
    this.transports = transports;
    this.membersTransports = membersTransports;
  }

  /** On the stepped clock, over the bus within the process: the same seed gives the same run. */
  public static LocalSite stepped(SiteSettings settings) {
    return stepped(settings, new SteppedClock());
  }

  /** The same on a clock of one's own, such as a shuffled one, that nobody has used yet. */
  public static LocalSite stepped(SiteSettings settings, SteppedClock clock) {
    InProcessBus bus = new InProcessBus(clock);
    LocalSite site =
        new LocalSite(settings, clock, clock::runUntil, Optional.empty(), bus::client, bus::client);
    site.bus = Optional.of(bus);
    return site.opened(DECISION_ON_STEPPED_CLOCK, STEPPED_OPENING);
  }

  /**
   * On the paced clock, over MQTT.
   *
   * @param speed simulated seconds per second of wall time
   * @throws SiteException when no broker answers, or devices stay away
   */
  public static LocalSite paced(SiteSettings settings, double speed) {
    OpenFiles.requireFor(settings.home().devices().size());
    settings.broker().ifPresent(LocalSite::requireBroker);
    Optional<EmbeddedBroker> own =
        settings.broker().isPresent() ? Optional.empty() : Optional.of(SiteBus.ownBroker(settings));
    URI uri = settings.broker().orElseGet(() -> own.orElseThrow().uri());
    SiteBus bus = new SiteBus(uri, settings.name(), settings.security());
    settings.broker().ifPresent(external -> bus.requireLetIn(CONTROLLER));
    Optional<SharedConnection> members =
        own.isPresent() && settings.security().isEmpty()
            ? Optional.of(bus.sharedByMembers())
            : Optional.empty();
    PacedClock clock = new PacedClock(speed);
    LocalSite site =
        new LocalSite(
            settings,
            clock,
            (condition, limit) -> poll(clock, condition, limit),
            Optional.of(uri),
            bus.transports(),
            members
                .<Function<String, Transport>>map(shared -> shared::client)
                .orElseGet(bus::transports));
    site.policy = bus.policy();
    site.kind = bus.kind();
    own.ifPresent(site.parts::opened);
    site.parts.opened(clock);
    members.ifPresent(site.parts::opened);
    Duration opening =
        PACED_OPENING.plus(OPENING_OF_A_DEVICE.multipliedBy(settings.home().devices().size()));
    return site.opened(Duration.ZERO, Duration.ofMillis((long) (opening.toMillis() * speed)));
  }

  /** A transport tries for ever, as it should in a site that runs. */
  private static void requireBroker(URI broker) {
    try (Socket socket = new Socket()) {
      socket.connect(
          new InetSocketAddress(broker.getHost(), broker.getPort()), BROKER_ANSWERS_WITHIN_MILLIS);
    } catch (IOException | IllegalArgumentException e) {
      throw new SiteException(
          "No MQTT broker answers at %s; start one there, or name another.".formatted(broker), e);
    }
  }

  private LocalSite opened(Duration decisionTime, Duration opening) {
    try {
      open(decisionTime, opening);
      return this;
    } catch (RuntimeException e) {
      close();
      throw e;
    }
  }

  private void open(Duration decisionTime, Duration opening) {
    KnowledgeBase knowledge = knowledge();
    simulated =
        settings
            .scene()
            .map(
                scene -> {
                  SimulatedHome.Setup setup =
                      new SimulatedHome.Setup(
                              settings.home(),
                              scene,
                              clock,
                              settings.seed(),
                              membersTransports,
                              settings.name(),
                              new DescriptionWriter(settings.home())::write)
                          .with(settings.physics())
                          .withPolicy(policy);
                  return SimulatedHome.start(bus.map(setup::on).orElse(setup));
                });
    simulated.ifPresent(parts::opened);
    RatsLink link = link(CONTROLLER);
    parts.opened(link);
    MaestroPlatform started =
        MaestroPlatform.start(
            PlatformSettings.of(settings.name())
                .port(settings.jadePort())
                .gui(settings.gui())
                .brokerUri(broker.map(URI::toString))
                .decisionTime(decisionTime)
                .storyDirectory(settings.storyDirectory())
                .dataDirectory(settings.dataDirectory())
                .guard(settings.security().map(files -> Guard.open(files, CONTROLLER)))
                .premises(settings.premises())
                .homeFile(settings.homeFile())
                .build(),
            new PlatformServices(
                knowledge,
                new ObjectivePlanner(
                    new ReplanningPlanner(new OptimalPlanner()), settings.allocation()),
                link,
                new ContainersNames(),
                clock,
                DescriptionReader.of(settings.home())::read));
    platform = Optional.of(started);
    parts.opened(started);
    awaitMembers(opening);
  }

  private final class ContainersNames implements OtherNames {
    /** Who was taken out of the site is not let in by the broker, whoever uses the name. */
    @Override
    public boolean mayBeUsed(String controller) {
      return settings.security().filter(site -> !site.hasNow(controller)).isEmpty();
    }

    @Override
    public RatsLink connect(String controller) {
      return link(controller);
    }
  }

  private RatsLink link(String controller) {
    return BusLink.connect(controller, settings.name(), transports.apply(controller), clock, kind);
  }

  private KnowledgeBase knowledge() {
    KnowledgeSettings kept =
        settings
            .dataDirectory()
            .map(directory -> KnowledgeSettings.in(directory.resolve("knowledge")))
            .orElseGet(KnowledgeSettings::inMemory);
    return new CalibratedKnowledge(
        parts.opened(
            CollectiveKnowledge.open(settings.home(), clock, kept.with(settings.store()))));
  }

  private void awaitMembers(Duration opening) {
    List<String> expected =
        simulated.stream()
            .flatMap(home -> home.devices().stream().filter(home.world()::isAlive))
            .toList();
    if (!runUntil(() -> isThereOrHomeless(expected), opening)) {
      Set<String> settled = settled();
      List<String> missing = expected.stream().filter(id -> !settled.contains(id)).toList();
      throw new SiteException(
          "Within %d simulated seconds %d of %d devices did not come: %s%s."
              .formatted(
                  opening.toSeconds(),
                  missing.size(),
                  expected.size(),
                  missing.stream().limit(MOST_NAMES).collect(Collectors.joining(", ")),
                  missing.size() > MOST_NAMES ? " and others" : ""));
    }
  }

  /** One whose agent needs another host than this process comes when such a host does. */
  private boolean isThereOrHomeless(List<String> expected) {
    return settled().containsAll(expected);
  }

  private Set<String> settled() {
    Set<String> settled = new TreeSet<>(platform().presentMembers());
    settled.addAll(platform().homeless());
    return settled;
  }

  /**
   * A member that is none of the home's devices joins the bus; it leaves with the site. It is ready
   * some messages later.
   */
  public RatsMember join(MemberProfile profile, MemberProfile.Values values) {
    RatsMember member =
        RatsMember.start(
            profile, values, membersTransports.apply(profile.id()), settings.name(), policy, clock);
    parts.opened(member);
    return member;
  }

  /**
   * A client of the bus beside all others, for one who only listens; not open yet.
   *
   * @throws org.maestro.rats.security.SecurityFilesException when it is a secured site whose files
   *     have no observer
   */
  public Transport observer() {
    // On an open site no member has this name: theirs have no such sign.
    return transports.apply(
        settings.security().isPresent() ? OBSERVER : CONTROLLER + "$" + OBSERVER);
  }

  public MaestroPlatform platform() {
    return platform.orElseThrow();
  }

  public Clock clock() {
    return clock;
  }

  /** Of the bus; empty when it lives within the process. */
  public Optional<URI> broker() {
    return broker;
  }

  /** The bus within the process, to disturb it. */
  public InProcessBus bus() {
    return bus.orElseThrow(
        () -> new SiteException("The site %s is on a real bus.".formatted(settings.name())));
  }

  /** The home as it was described at the start. */
  public Home home() {
    return settings.home();
  }

  /** Whether devices and the world they live in are simulated here. */
  public boolean isSimulated() {
    return simulated.isPresent();
  }

  /** The simulated devices and the world they live in. */
  public SimulatedHome simulated() {
    return simulated.orElseThrow(
        () -> new SiteException("The site %s runs no simulation.".formatted(settings.name())));
  }

  public World world() {
    return simulated().world();
  }

  /**
   * Lets time pass until the condition holds.
   *
   * @param limit simulated time
   * @return whether it holds
   */
  public boolean runUntil(BooleanSupplier condition, Duration limit) {
    return driver.runUntil(condition, limit);
  }

  @Override
  public void close() {
    parts.close();
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
