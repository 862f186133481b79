package org.maestro.experiment;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.running.Ending;
import org.maestro.experiment.running.Trail;
import org.maestro.experiment.running.Trial;
import org.maestro.experiment.running.TrialSite;
import org.maestro.experiment.setting.Physics;
import org.maestro.experiment.setting.Setting;
import org.maestro.experiment.setting.Settings;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Home;
import org.maestro.picture.TopView;
import org.maestro.planning.api.Objective;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.world.World;

/**
 * A thing was to be brought next to another: what came of it.
 *
 * @param brightestLux the most light upon one of the things at the beginning
 * @param apartMetres between the two in the end
 * @param moved what was carried somewhere, in the simulated world
 * @param aims where the robot headed to grasp something or to put it down, in order
 * @param pictures of what happened; mostly none
 */
record MoveRun(
    int number,
    long seed,
    Job job,
    double solarHours,
    Ending ending,
    boolean success,
    double seconds,
    double boundSeconds,
    double brightestLux,
    double apartMetres,
    Trail trail,
    List<String> moved,
    List<Aim> aims,
    List<Figure> pictures)
    implements GoalRun {
  private static final Duration PATIENCE = Duration.ofMinutes(10);

  /** The agent that sees to the light has done so when the goal comes. */
  private static final Duration SETTLED = Duration.ofSeconds(20);

  private static final double MOVED_METRES = 0.2;

  private static final String SOONEST = "platform.soonest";

  /** So fine that no square of the floor has more samples than its share by chance. */
  static final Duration TRAIL_STEP = Duration.ofMillis(20);

  /** A camera needs five frames at least for one look. */
  private static final double LOOK_FRAMES = 5;

  /** A thing to be moved, and the one next to which it is to end. */
  record Job(String carried, String target) {
    String goal() {
      return "(nextTo %s %s)".formatted(carried, target);
    }
  }

  static List<Setting> settings() {
    return List.of(
        Setting.truth(
            SOONEST,
            false,
            "whether plans are to be over soonest, rather than to cost least (seconds and"
                + " energy)"));
  }

  /**
   * @param pace simulated seconds per second over the real broker; empty: stepped
   */
  static MoveRun carryOut(
      int number, long seed, Job job, Settings settings, OptionalDouble pace, boolean drawn) {
    PhysicalParameters physics = Physics.of(settings);
    Home home = Laboratory.home(job.carried(), physics.camera().noticesGlare());
    Trial trial =
        new Trial(
            "move-" + number,
            home,
            Laboratory.scene(settings, home, number, seed),
            seed,
            physics,
            settings.truth(SOONEST) ? Objective.EARLIEST_FINISH : Objective.CHEAPEST,
            pace);
    try (TrialSite site = TrialSite.open(trial)) {
      World world = site.world();
      double bound =
          site.simulated().lowerBound(Laboratory.ROBOT, job.carried(), job.target()).toMillis()
                  / 1e3
              + physics.arm().foldSeconds()
              + 2 * LOOK_FRAMES / physics.camera().frameRate();
      double brightest =
          Laboratory.THINGS.stream()
              .mapToDouble(thing -> world.lux(world.position(thing).orElseThrow()))
              .max()
              .orElseThrow();
      Position start = world.position(Laboratory.ROBOT).orElseThrow();
      TopView view = new TopView(home, world);
      List<Figure> pictures = new ArrayList<>();
      site.run(SETTLED);
      if (drawn) {
        pictures.add(photo(site, number));
      }
      Map<String, Position> before = places(world);
      Duration begun = site.clock().now();
      Supplier<List<Aim>> aims = Aim.watched(site, job);
      Ending ending = site.pursue(job.goal(), PATIENCE);
      double seconds = ending.seconds(site.clock().now());
      Trail trail =
          Trail.sampled(
              world.path(Laboratory.ROBOT),
              start.floor(),
              begun,
              begun.plusMillis(Math.round(1e3 * seconds)),
              TRAIL_STEP);
      if (drawn) {
        pictures.add(picture(view, number));
      }
      return new MoveRun(
          number,
          seed,
          job,
          Laboratory.solarHours(settings, number),
          ending,
          world.isNextTo(job.carried(), job.target()),
          seconds,
          bound,
          brightest,
          world.distance(job.carried(), job.target()),
          trail,
          before.entrySet().stream()
              .filter(then -> then.getValue().distance(place(world, then.getKey())) > MOVED_METRES)
              .map(Map.Entry::getKey)
              .toList(),
          aims.get(),
          pictures);
    }
  }

  /** In the order of the things. */
  private static Map<String, Position> places(World world) {
    Map<String, Position> places = new LinkedHashMap<>();
    Laboratory.THINGS.forEach(thing -> places.put(thing, place(world, thing)));
    return places;
  }

  private static Position place(World world, String thing) {
    return world.position(thing).orElseThrow();
  }

  private static Figure photo(TrialSite site, int number) {
    return Figure.of(
        "camera-" + number,
        "What camera 1 shows when run %d begins.".formatted(number),
        site.simulated().photo(Laboratory.CAMERAS.get(0)));
  }

  static Figure picture(TopView view, int number) {
    try {
      Path file = Files.createTempFile("maestro-run", ".png");
      try {
        view.write(file);
        return Figure.read(
            "run-" + number,
            "Run %d at its end, from above, with the robot's way.".formatted(number),
            file);
      } finally {
        Files.delete(file);
      }
    } catch (IOException e) {
      throw new UncheckedIOException("No temporary file for a picture can be written.", e);
    }
  }

  /** Whether the robot grasped where another thing lay, or carried another one off. */
  boolean tookTheWrongThing() {
    return moved.stream().anyMatch(thing -> !thing.equals(job.carried()))
        || aims.stream().anyMatch(aim -> aim.grasping() && aim.isOccupied());
  }

  /** Whether it drove to a place that another thing occupies than the one it meant. */
  boolean droveToAnOccupiedPlace() {
    return aims.stream().anyMatch(Aim::isOccupied);
  }

  double ratio() {
    return seconds / boundSeconds;
  }

  @Override
  public String goal() {
    return job.goal();
  }

  @Override
  public String failure() {
    if (success) {
      return "";
    }
    String taken =
        moved.isEmpty() || moved.contains(job.carried())
            ? ""
            : " In truth %s was carried off.".formatted(String.join(", ", moved));
    return ending.claimed()
        ? String.format(
            Locale.ROOT,
            "The platform says that it is done, but it is not: the two are %.2f m apart.%s",
            apartMetres,
            taken)
        : ending.explanation() + taken;
  }
}
