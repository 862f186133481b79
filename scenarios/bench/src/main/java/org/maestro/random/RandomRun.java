package org.maestro.random;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BiFunction;
import org.maestro.assembly.AgentlessSite;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.Journal;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sl.Formula;

/**
 * One random home, its goals pursued while its faults strike, and every claim judged.
 *
 * @param verdicts one for each goal, in the goals' order
 * @param story of all goals, line by line: the same for the same seed
 * @param contacts of robots and persons who ran into each other
 */
public record RandomRun(
    RandomHome home, List<Verdict> verdicts, List<String> story, List<String> contacts) {
  private static final Duration LONGEST = Duration.ofMinutes(20);

  /** Longer than the latest fault takes to strike. */
  private static final Duration HELD = Duration.ofSeconds(100);

  /** An onlooker, who may disturb. Told on the thread that lets time pass. */
  public interface Onlooker {
    /** The site is open, and no goal is stated yet. */
    void begin(InProcessBus bus, Clock clock);

    /** Where the heart alone writes down its goals; the clock is that of its process. */
    default Journal journal(Home home, Clock clock) {
      return Journal.none();
    }

    /** A goal was taken on. */
    default void accepted(String goalId) {}

    /** A goal has ended, and that is told. */
    default void ended(GoalOutcome outcome) {}
  }

  /** Runs without agents. */
  public static RandomRun withoutAgents(RandomHome random) {
    return withoutAgents(random, (bus, clock) -> {});
  }

  /** The same before somebody's eyes. */
  public static RandomRun withoutAgents(RandomHome random, Onlooker onlooker) {
    return run(
        random,
        onlooker,
        (home, scene) ->
            new ArenaWithoutAgents(
                AgentlessSite.start(
                    home,
                    scene,
                    random.seed(),
                    PhysicalParameters.standard().with(random.physics()),
                    clock -> onlooker.journal(home, clock)),
                onlooker));
  }

  /** The same with the whole platform. */
  public static RandomRun withAgents(RandomHome random) {
    return withAgents(random, (bus, clock) -> {});
  }

  /** The same before somebody's eyes. */
  public static RandomRun withAgents(RandomHome random, Onlooker onlooker) {
    return run(
        random,
        onlooker,
        (home, scene) ->
            new ArenaWithAgents(
                LocalSite.stepped(
                    SiteSettings.of(random.name(), home)
                        .scene(scene)
                        .seed(random.seed())
                        .physics(PhysicalParameters.standard().with(random.physics()))
                        .build())));
  }

  private static RandomRun run(
      RandomHome random, Onlooker onlooker, BiFunction<Home, Scene, Arena> arenas) {
    Home home = new HomeLoader().load(random.homeText(), random.name() + ".ttl");
    Scene scene =
        SceneLoader.load(
            random.name(),
            new ByteArrayInputStream(random.sceneText().getBytes(StandardCharsets.UTF_8)),
            home);
    Site site = new Site(home, scene);
    try (Arena arena = arenas.apply(home, scene)) {
      Judge judge =
          new Judge(
              site,
              () -> Moment.of(arena.world(), site, arena.clock().now()),
              () -> arena.knowledge().snapshot());
      Contacts contacts = new Contacts(arena.world(), site);
      onlooker.begin(arena.bus(), arena.clock());
      random.faults().forEach(fault -> prepare(fault, arena, judge, contacts));
      Map<Integer, Verdict> verdicts = new TreeMap<>();
      Map<Integer, Holding> holdings = new TreeMap<>();
      for (int i = 0; i < random.goals().size(); i++) {
        String goal = random.goals().get(i);
        int number = i;
        if (arena.parsed(goal) instanceof Formula.Keep keep) {
          Holding holding = new Holding(goal, keep.body(), judge);
          holdings.put(i, holding);
          judge.isToBeHeld(keep.body());
          arena.hold(goal, claim -> holding.told(claim, arena.clock().now()));
        } else {
          arena.pursue(
              goal,
              claim ->
                  verdicts.put(number, judge.of(arena.parsed(goal), claim, arena.clock().now())),
              reason -> verdicts.put(number, Verdict.refused(goal, reason)));
        }
      }
      Duration begin = arena.clock().now();
      arena.runUntil(
          () -> {
            Duration now = arena.clock().now();
            contacts.timePassed();
            if (judge.timePassed(now)) {
              holdings.values().forEach(holding -> holding.timePassed(now));
            }
            return verdicts.size() + holdings.size() == random.goals().size()
                && holdings.values().stream().allMatch(Holding::isJudged)
                && (holdings.isEmpty() || now.minus(begin).compareTo(HELD) > 0);
          },
          LONGEST);
      holdings.forEach((i, holding) -> verdicts.put(i, holding.verdict()));
      for (int i = 0; i < random.goals().size(); i++) {
        verdicts.putIfAbsent(i, Verdict.withoutEnd(random.goals().get(i)));
      }
      return new RandomRun(random, List.copyOf(verdicts.values()), arena.story(), contacts.found());
    }
  }

  private static void prepare(Fault fault, Arena arena, Judge judge, Contacts contacts) {
    arena
        .clock()
        .schedule(
            fault.at(),
            "fault",
            () -> {
              fault.strike(arena);
              contacts.forget();
              judge.struck(fault, arena.clock().now());
            });
  }

  /** Whether no claim was false, and nobody was run into. */
  public boolean agrees() {
    return contacts.isEmpty() && verdicts.stream().allMatch(verdict -> verdict.kind().agrees());
  }

  /** Everything that is needed to understand it, and how to see it again. */
  public String text() {
    return """
    Seed %d. To see it again: mvn test -pl scenarios/bench -am \
    -Dtest=RandomHomesTest -Dsurefire.failIfNoSpecifiedTests=false -Dmaestro.seed=%d
    %s
    %s
    %s
    %s
    %s
    %s\
    """
        .formatted(
            home.seed(),
            home.seed(),
            verdicts,
            contacts,
            home.faults(),
            String.join("\n", story),
            home.sceneText(),
            home.homeText());
  }
}
