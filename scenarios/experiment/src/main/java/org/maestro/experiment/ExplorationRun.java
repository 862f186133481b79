package org.maestro.experiment;

import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.SplittableRandom;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.drawing.Terrain;
import org.maestro.experiment.running.Conversation;
import org.maestro.experiment.running.Trial;
import org.maestro.experiment.running.TrialSite;
import org.maestro.experiment.setting.Physics;
import org.maestro.experiment.setting.Setting;
import org.maestro.experiment.setting.Settings;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.home.Home;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.FloorMap;
import org.maestro.sim.world.PathPoint;
import org.maestro.sim.world.World;

/**
 * A simulated subject has directed the robot, until data was sent or its time was over.
 *
 * @param success in the simulated world
 * @param seconds until the data was sent, or until the time was over
 * @param boundSeconds nobody could do it in less
 * @param utterances how often the subject has said something
 * @param readings that it has heard
 * @param lines all that was said, in order
 */
record ExplorationRun(
    int number,
    long seed,
    Condition condition,
    boolean success,
    double seconds,
    double boundSeconds,
    int utterances,
    List<Integer> readings,
    List<Line> lines,
    List<Figure> pictures) {
  private static final String HOME = "exploration";
  private static final String ROBOT = "rover";
  private static final String PERSON = "explorer";

  /** Of the shipped home's crater. */
  private static final double SIDE_METRES = 20;

  /** Longer than any mission. */
  private static final Duration NO_LONGER = Duration.ofMinutes(30);

  private static final Setting LEAST_DELAY =
      Setting.number("subject.delay.least", 1, 0, 60, "s before anything is said; assumed");
  private static final Setting MEAN_DELAY =
      Setting.number(
          "subject.delay.mean",
          4,
          0,
          600,
          "s before anything is said, in the mean; what is beyond the least is exponentially distributed; assumed");
  private static final Setting ERRORS =
      Setting.number(
          "subject.errors",
          0.1,
          0,
          1,
          "share of turns, and of comparisons of readings, in which the subject errs; assumed");

  /**
   * An experimental condition.
   *
   * @param affect whether the robot's voice is stressed after its first report, or neutral
   * @param kappa share by which the subject thinks shorter once it has heard a stressed voice
   */
  record Condition(boolean affect, double kappa) {
    String label() {
      return affect ? "affect, κ = " + kappa : "control";
    }

    String key() {
      return affect ? "affect" : "control";
    }

    private String mission() {
      return "(mission %s \"%s\" %s)"
          .formatted(PERSON, affect ? SimulatedSubject.STRESSED : "neutral", affect ? "0.8" : "0");
    }
  }

  /**
   * Something that was said.
   *
   * @param second since the run began
   * @param voice in which; "" of the subject, and of the robot before it has shown any
   */
  record Line(double second, String who, String voice, String text) {}

  static List<Setting> settings() {
    return List.of(
        LEAST_DELAY,
        MEAN_DELAY,
        ERRORS,
        Physics.setting("world.signal.peak"),
        Physics.setting("world.signal.halfMetres"),
        Physics.setting("world.signal.needed"));
  }

  /**
   * @param pictured whether a picture is taken of its end
   */
  static ExplorationRun carryOut(
      int number, long seed, Condition condition, Settings settings, boolean pictured) {
    Home home = Shipped.home(HOME);
    Scene scene = Shipped.scene(HOME, home);
    Trial trial = new Trial(HOME + "-" + number, home, scene, seed, Physics.of(settings));
    try (TrialSite site = TrialSite.open(trial)) {
      List<Duration> sent = new CopyOnWriteArrayList<>();
      site.world()
          .listen(
              event -> {
                if (event.kind() == WorldEvent.Kind.TRANSMITTED) {
                  sent.add(event.at());
                }
              });
      Conversation talk = site.conversation(PERSON);
      site.run(Duration.ofSeconds(1));
      double bound = boundSeconds(site.world(), home, settings);
      Duration begun = site.clock().now();
      TrialSite.Underway mission = site.begin(condition.mission());
      SimulatedSubject subject =
          new SimulatedSubject(talk, manner(condition, settings), new SplittableRandom(seed));
      subject.explore();
      if (sent.isEmpty()) {
        site.runUntil(mission::hasEnded, NO_LONGER);
      }
      Duration ended = sent.isEmpty() ? site.clock().now() : sent.get(0);
      return new ExplorationRun(
          number,
          seed,
          condition,
          !sent.isEmpty(),
          seconds(ended, begun),
          bound,
          talk.said().size(),
          subject.readings(),
          lines(talk, begun),
          pictured ? List.of(picture(site.world(), settings, number)) : List.of());
    }
  }

  private static Figure picture(World world, Settings settings, int number) {
    return Figure.of(
        "run-" + number,
        "The first subject's run, from above: the signal, which the subject does not see, and the robot's way.",
        Terrain.draw(
            "The robot's way over the signal",
            SIDE_METRES,
            world.signal()::strength,
            Physics.of(settings).signal().peak(),
            "signal, the darker the stronger",
            world.whereabouts().obstacles(ROBOT).stream()
                .map(rock -> new Terrain.Body(rock.middle(), rock.radius()))
                .toList(),
            world.path(ROBOT).stream().map(PathPoint::point).toList()));
  }

  private static List<Line> lines(Conversation talk, Duration begun) {
    return Stream.concat(
            talk.said().stream()
                .map(one -> new Line(seconds(one.at(), begun), "subject", "", one.words())),
            talk.heard().stream()
                .map(one -> new Line(seconds(one.at(), begun), "robot", one.voice(), one.text())))
        .sorted(Comparator.comparingDouble(Line::second))
        .toList();
  }

  private static SimulatedSubject.Manner manner(Condition condition, Settings settings) {
    double least = settings.number(LEAST_DELAY.name());
    return new SimulatedSubject.Manner(
        least,
        Math.max(least, settings.number(MEAN_DELAY.name())),
        settings.number(ERRORS.name()),
        condition.kappa(),
        Physics.of(settings).signal().needed());
  }

  private static double seconds(Duration at, Duration begun) {
    return at.minus(begun).toMillis() / 1e3;
  }

  /** Straight to where the signal is just strong enough, at full speed, and the transmission. */
  private static double boundSeconds(World world, Home home, Settings settings) {
    Point2 start = world.position(ROBOT).orElseThrow().floor();
    double way = Math.max(0, start.distance(world.signal().peak()) - world.signal().reachMetres());
    double speed =
        FloorMap.number(Objects.requireNonNull(home.individuals().get(ROBOT)), "speed")
            .orElseThrow();
    return way / speed + Physics.of(settings).signal().transmitSeconds();
  }

  /** Whether the subject was told something in a stressed voice. */
  boolean isStressHeard() {
    return lines.stream().anyMatch(line -> line.voice().equals(SimulatedSubject.STRESSED));
  }

  /** Why it was no success; empty when it was. */
  String failure() {
    return success
        ? ""
        : "The time was over; the strongest reading was "
            + readings.stream().mapToInt(Integer::intValue).max().orElse(0)
            + ".";
  }
}
