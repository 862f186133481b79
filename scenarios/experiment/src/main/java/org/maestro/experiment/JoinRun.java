package org.maestro.experiment;

import java.time.Duration;
import java.util.List;
import java.util.SplittableRandom;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.experiment.running.Ending;
import org.maestro.experiment.running.Trial;
import org.maestro.experiment.running.TrialSite;
import org.maestro.experiment.setting.Physics;
import org.maestro.experiment.setting.Settings;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Home;
import org.maestro.sim.scene.Scene;

/**
 * A goal was pursued while members came and went.
 *
 * @param broken the plan could not be followed to its end as it was made
 * @param success in the simulated world
 */
record JoinRun(
    int number,
    long seed,
    Way way,
    Comings comings,
    Ending ending,
    boolean broken,
    boolean success,
    double seconds)
    implements GoalRun {
  private static final String GOAL = "(nextTo Cup Bob)";
  private static final String HOME = "bob-two-robots";
  private static final String THING = "Cup";
  private static final String TARGET = "Bob";
  private static final List<String> ROBOTS = List.of("rose", "tim");
  private static final Duration PATIENCE = Duration.ofMinutes(5);

  /** The condition under which the goal is pursued. */
  enum Way {
    /** Nobody comes, goes or fails. */
    UNDISTURBED(0),
    /** The platform plans again whenever its plan does not hold any more. */
    REPLANNING(1),
    /** The same first plan, with everything known, is followed until it does not hold any more. */
    FIXED_PLAN(2);

    /** In the names of sites. */
    private final int number;

    Way(int number) {
      this.number = number;
    }
  }

  static JoinRun carryOut(int number, long seed, Way way, Settings settings) {
    Home home = Shipped.home(HOME);
    List<String> others =
        home.devices().keySet().stream().filter(device -> !ROBOTS.contains(device)).toList();
    Comings comings =
        way == Way.UNDISTURBED ? new Comings(List.of()) : Comings.drawn(seed, ROBOTS, others);
    Trial trial =
        new Trial(
            "join-%d-%d".formatted(way.number, number),
            home,
            scene(home, seed),
            seed,
            Physics.of(settings));
    try (TrialSite site = TrialSite.open(trial)) {
      // Everything is known when the plan is made, so that a fixed plan needs no search.
      site.pursue("(canSee ?agent %s)".formatted(THING), PATIENCE);
      site.pursue("(canSee ?agent %s)".formatted(TARGET), PATIENCE);
      comings.schedule(site);
      TrialSite.Underway underway = site.begin(GOAL);
      site.runUntil(
          () -> underway.hasEnded() || way == Way.FIXED_PLAN && isBroken(underway.ending()),
          PATIENCE);
      Ending ending = underway.ending();
      return new JoinRun(
          number,
          seed,
          way,
          comings,
          ending,
          isBroken(ending),
          site.world().isNextTo(THING, TARGET),
          ending.seconds(site.clock().now()));
    }
  }

  /** A step failed, or the rest of the plan became impossible. */
  private static boolean isBroken(Ending ending) {
    return ending.story().stream()
        .anyMatch(
            entry ->
                entry.kind() == StoryEntry.Kind.FAILED || entry.kind() == StoryEntry.Kind.REPLAN);
  }

  /** The cup stands somewhere else in room B each time. */
  private static Scene scene(Home home, long seed) {
    Scene scene = Shipped.scene(HOME, home);
    SplittableRandom random = new SplittableRandom(~seed);
    return scene.with(
        THING,
        scene
            .of(THING)
            .at(new Position(4.2 + 1.3 * random.nextDouble(), 1.6 + random.nextDouble(), 0)));
  }

  @Override
  public String goal() {
    return GOAL;
  }

  /** Whoever follows a fixed plan claims nothing. */
  @Override
  public boolean falseClaim() {
    return way != Way.FIXED_PLAN && GoalRun.super.falseClaim();
  }

  @Override
  public String failure() {
    if (success) {
      return "";
    }
    if (way == Way.FIXED_PLAN && broken) {
      return "The plan could not be followed: "
          + ending.story().stream()
              .filter(
                  entry ->
                      entry.kind() == StoryEntry.Kind.FAILED
                          || entry.kind() == StoryEntry.Kind.REPLAN)
              .map(StoryEntry::text)
              .findFirst()
              .orElse("nobody says why.");
    }
    return ending.claimed()
        ? "The platform says that it is done, but it is not."
        : ending.explanation();
  }
}
