package org.maestro.assembly;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.HeldNews;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.coordination.api.Thinking;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.calibration.CalibratedKnowledge;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Home;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.ReplanningPlanner;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.sim.SimulatedHome;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.world.World;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/**
 * A site without agents: knowledge, planning and coordination straight over the link, on the
 * stepped clock and the bus within the process. It shows what the heart does by itself, some
 * hundred times as fast as with agents. The same home, scene and seed give the same stories. For
 * one thread.
 */
public final class AgentlessSite implements AutoCloseable {
  private static final String SITE = "agentless";
  private static final String CONTROLLER = "maestro";
  private static final Duration DECISION = Duration.ofMillis(20);

  /** Much is tried here in a short time: what is larger than this is given up, and said so. */
  private static final int MOST_STATES = 20_000;

  private static final Duration OPENING = Duration.ofSeconds(60);

  private final OpenParts parts = new OpenParts();
  private final List<StoryEntry> story = new ArrayList<>();
  private final SteppedClock clock;
  private final FreezableClock whole;
  private final FreezableClock main;
  private final InProcessBus bus;
  private final KnowledgeBase knowledge;
  private final SimulatedHome simulated;
  private final Coordinator coordinator;

  private AgentlessSite(
      Home home,
      Scene scene,
      long seed,
      PhysicalParameters physics,
      SteppedClock clock,
      Function<Clock, Journal> journals) {
    this.clock = clock;
    whole = new FreezableClock(clock, seed);
    main = new FreezableClock(whole, seed);
    bus = new InProcessBus(whole);
    knowledge = new CalibratedKnowledge(parts.opened(new CollectiveKnowledge(home, main)));
    simulated =
        parts.opened(
            SimulatedHome.start(
                new SimulatedHome.Setup(
                        home,
                        scene,
                        whole,
                        seed,
                        bus::client,
                        SITE,
                        new DescriptionWriter(home)::write)
                    .with(physics)
                    .on(bus)));
    BusLink link =
        parts.opened(BusLink.connect(CONTROLLER, SITE, bus.client(CONTROLLER, main), main));
    Deputies deputies = new Deputies(link, main, knowledge, DescriptionReader.of(home)::read);
    coordinator =
        new Coordinator(
            new Ports(
                knowledge,
                new ReplanningPlanner(new OptimalPlanner(MOST_STATES)),
                new LinkContractNet(deputies),
                new LinkActionDispatcher(deputies, link),
                new InTurn(main),
                action -> main.schedule(Duration.ZERO, CONTROLLER, action),
                main,
                story::add,
                journals.apply(main)));
    deputies.report(coordinator);
    knowledge.watch(
        change ->
            main.schedule(Duration.ZERO, CONTROLLER, () -> coordinator.knowledgeChanged(change)));
  }

  /**
   * Opens the site and lets time pass until all devices that have power are there.
   *
   * @param seed of all chance in the world
   * @throws SiteException when devices stay away
   */
  public static AgentlessSite start(Home home, Scene scene, long seed) {
    return start(home, scene, seed, new SteppedClock());
  }

  /** The same on a clock of one's own, such as a shuffled one, that nobody has used yet. */
  public static AgentlessSite start(Home home, Scene scene, long seed, SteppedClock clock) {
    return opened(
        new AgentlessSite(
            home, scene, seed, PhysicalParameters.standard(), clock, main -> Journal.none()));
  }

  /**
   * The same in a world of one's own with a journal, which its maker closes.
   *
   * @param journals makes it, on the clock of the heart's process
   */
  public static AgentlessSite start(
      Home home,
      Scene scene,
      long seed,
      PhysicalParameters physics,
      Function<Clock, Journal> journals) {
    return opened(new AgentlessSite(home, scene, seed, physics, new SteppedClock(), journals));
  }

  private static AgentlessSite opened(AgentlessSite site) {
    List<String> expected =
        site.simulated.devices().stream().filter(site.world()::isAlive).toList();
    if (!site.runUntil(() -> expected.stream().allMatch(site.coordinator::isPresent), OPENING)) {
      site.close();
      throw new SiteException(
          "Not all of these devices came within %d simulated seconds: %s."
              .formatted(OPENING.toSeconds(), String.join(", ", expected)));
    }
    return site;
  }

  /**
   * States a goal.
   *
   * @param goal in MAESTRO-SL
   * @return the goal's id
   */
  public String pursue(String goal, Consumer<GoalOutcome> ended) {
    return coordinator.submit(new GoalRequest(parsed(goal), "somebody"), ended);
  }

  /**
   * States a goal that may be refused.
   *
   * @param goal in MAESTRO-SL
   */
  public String pursue(String goal, Coordinator.Answer answer, Consumer<GoalOutcome> ended) {
    return coordinator.submit(new GoalRequest(parsed(goal), "somebody"), answer, news -> {}, ended);
  }

  /**
   * States a goal that is to be held.
   *
   * @param goal in MAESTRO-SL, {@code (keep ...)}
   * @return the goal's id
   */
  public String hold(String goal, Consumer<HeldNews> told) {
    return coordinator.submit(new GoalRequest(parsed(goal), "somebody"), told, outcome -> {});
  }

  /** Reads a formula in the words of this site's home. */
  public Formula parsed(String goal) {
    return SlParser.formula(
        goal,
        name ->
            knowledge
                .home()
                .vocabulary()
                .predicate(name)
                .filter(predicate -> predicate.fluent())
                .isPresent());
  }

  public Coordinator coordinator() {
    return coordinator;
  }

  public KnowledgeBase knowledge() {
    return knowledge;
  }

  public World world() {
    return simulated.world();
  }

  /** To disturb it. */
  public InProcessBus bus() {
    return bus;
  }

  public SteppedClock clock() {
    return clock;
  }

  /** The process of the heart does nothing for so long, while devices and bus go on. */
  public void freezeMain(Duration lasting) {
    main.freeze(lasting);
  }

  /** Nothing is done for so long, though time passes: all of it is in one process. */
  public void freezeWhole(Duration lasting) {
    whole.freeze(lasting);
  }

  /** What was told of all goals up to now. */
  public List<StoryEntry> story() {
    return List.copyOf(story);
  }

  /**
   * Lets time pass until the condition holds.
   *
   * @param limit simulated time
   * @return whether it holds
   */
  public boolean runUntil(BooleanSupplier condition, Duration limit) {
    return clock.runUntil(condition, limit);
  }

  @Override
  public void close() {
    parts.close();
  }

  /** Thinks on the clock's thread; a decision takes its simulated time all the same. */
  private record InTurn(Clock clock) implements Thinking {
    @Override
    public <T> void think(Supplier<T> work, Consumer<T> then) {
      clock.schedule(
          Duration.ZERO,
          CONTROLLER,
          () -> {
            T result = work.get();
            clock.schedule(DECISION, CONTROLLER, () -> then.accept(result));
          });
    }
  }
}
