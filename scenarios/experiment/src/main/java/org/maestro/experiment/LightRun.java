package org.maestro.experiment;

import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Predicate;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.experiment.running.Trial;
import org.maestro.experiment.running.TrialSite;
import org.maestro.experiment.setting.Physics;
import org.maestro.experiment.setting.Settings;
import org.maestro.hal.Camera;
import org.maestro.hal.Photo;
import org.maestro.hal.Target;
import org.maestro.ontology.home.Home;

/**
 * A camera was watched for a while, in light that changes by itself.
 *
 * @param samples five each second
 * @param story what agents told meanwhile
 * @param photo what the camera shows at the end
 */
record LightRun(
    int number, long seed, Case kind, List<Sample> samples, List<StoryEntry> story, Photo photo) {
  static final String ZONE = "zone-2";
  static final String OBJECT = "GreenObject";
  static final String CAMERA = "cam-2";

  /** When light falls in {@link Case#RECOVERY}; seconds. */
  static final int FALL = 10;

  private static final int SECONDS = 30;
  private static final int SAMPLES_PER_SECOND = 5;

  /** Of a fifth of a second, at 30 frames a second. */
  private static final int FRAMES = 6;

  private static final Set<StoryEntry.Kind> TOLD =
      EnumSet.of(
          StoryEntry.Kind.HELD, StoryEntry.Kind.LOST, StoryEntry.Kind.PLAN, StoryEntry.Kind.DONE);

  private static final double BEFORE = 80;
  private static final double PERIOD_SECONDS = 20;

  /** The course of the light in a run. */
  enum Case {
    /** Nobody sees to the light: 16 to 19 lux, as in the paper. */
    DARK(0),
    /** Light falls to 40 lux, and an agent sees to it. */
    RECOVERY(1);

    /** In the names of sites. */
    private final int number;

    Case(int number) {
      this.number = number;
    }
  }

  /**
   * @param lux at the zone's reference point, where the sensor stands
   * @param detections of so many frames
   */
  record Sample(double second, double lux, double objectLux, int frames, int detections) {
    double rate() {
      return (double) detections / frames;
    }
  }

  static LightRun carryOut(int number, long seed, Case kind, Settings settings) {
    Home home =
        kind == Case.DARK ? Shipped.home("arena") : Shipped.home("arena", ILLUMINATION_AGENT);
    Trial trial =
        new Trial(
            "light-" + kind.number + "-" + number,
            home,
            Shipped.scene("arena-light", home),
            seed,
            Physics.of(settings));
    DoubleUnaryOperator ambient = ambient(kind, settings);
    try (TrialSite site = TrialSite.open(trial)) {
      List<StoryEntry> story = new CopyOnWriteArrayList<>();
      site.listen(story::add);
      Camera camera =
          site.simulated()
              .drivers(CAMERA)
              .find(Camera.class)
              .orElseThrow(() -> new IllegalStateException(CAMERA + " is no camera."));
      List<Sample> samples = new ArrayList<>();
      for (int step = 0; step < SECONDS * SAMPLES_PER_SECOND; step++) {
        double second = (double) step / SAMPLES_PER_SECOND;
        double lux = ambient.applyAsDouble(second);
        home.individuals().keySet().stream()
            .filter(name -> name.startsWith("zone-"))
            .forEach(zone -> site.world().setAmbient(zone, lux));
        samples.add(sample(site, camera, second));
      }
      return new LightRun(
          number,
          seed,
          kind,
          List.copyOf(samples),
          List.copyOf(story),
          site.simulated().photo(CAMERA));
    }
  }

  /** The agent that the paper calls so. */
  private static final String ILLUMINATION_AGENT =
      """
      home:illumination-agent a maestro:GroupAgent ; rdfs:label "the illumination agent"@en ;
        maestro:memberWhen "(or (Lamp ?member) (LightSensor ?member))" ;
        maestro:pursues "(keep (>= (illuminance zone-2) 72))" .
      """;

  private static DoubleUnaryOperator ambient(Case kind, Settings settings) {
    double least = settings.number(Illumination.DARKEST);
    double most = settings.number(Illumination.DARK_MOST);
    double fallen = settings.number(Illumination.FALLEN);
    return kind == Case.DARK
        ? second ->
            (least + most) / 2
                + (most - least) / 2 * Math.sin(2 * Math.PI * second / PERIOD_SECONDS)
        : second -> second < FALL ? BEFORE : fallen;
  }

  /** The frames of a fifth of a second, and the light at their end. */
  private static Sample sample(TrialSite site, Camera camera, double second) {
    AtomicReference<Camera.Look> look = new AtomicReference<>();
    AtomicReference<String> failure = new AtomicReference<>();
    site.clock()
        .schedule(
            Duration.ZERO,
            "watch",
            () ->
                camera.look(
                    new Target(OBJECT, Map.of("colour", "green")),
                    FRAMES,
                    new Camera.Listener() {
                      @Override
                      public void looked(Camera.Look seen) {
                        look.set(seen);
                      }

                      @Override
                      public void failed(String reason) {
                        failure.set(reason);
                      }
                    }));
    site.run(Duration.ofMillis(1_000 / SAMPLES_PER_SECOND));
    site.runUntil(() -> look.get() != null || failure.get() != null, Duration.ofSeconds(1));
    double lux = site.world().lux(ZONE);
    double objectLux = site.world().lux(site.world().position(OBJECT).orElseThrow());
    Camera.Look seen = look.get();
    return new Sample(second, lux, objectLux, FRAMES, seen == null ? 0 : seen.detections());
  }

  /** Seconds from the fall of light until there is enough again; empty when there never is. */
  OptionalDouble recoverySeconds() {
    return samples.stream()
        .filter(sample -> sample.second() > FALL && sample.lux() >= Illumination.THRESHOLD)
        .mapToDouble(sample -> sample.second() - FALL)
        .findFirst();
  }

  /** Detections of all frames in light of which the condition holds. */
  static double rate(List<LightRun> runs, Predicate<Sample> when) {
    int frames = 0;
    int detections = 0;
    for (LightRun run : runs) {
      for (Sample sample : run.samples()) {
        if (when.test(sample)) {
          frames += sample.frames();
          detections += sample.detections();
        }
      }
    }
    return frames == 0 ? Double.NaN : (double) detections / frames;
  }

  /** The plan by which the agent raised the light, as it told it. */
  /** What it found and planned, and when: it counts its plans anew after each loss. */
  List<String> plans() {
    return story.stream()
        .filter(entry -> TOLD.contains(entry.kind()))
        .map(
            entry ->
                String.format(
                    Locale.ROOT, "%.1f s: %s", entry.at().toMillis() / 1000.0, entry.text()))
        .toList();
  }
}
