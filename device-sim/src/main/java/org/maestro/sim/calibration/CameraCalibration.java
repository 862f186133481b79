package org.maestro.sim.calibration;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicReference;
import org.maestro.hal.Area;
import org.maestro.hal.Camera;
import org.maestro.hal.Position;
import org.maestro.hal.Target;
import org.maestro.hal.sight.Appearance;
import org.maestro.hal.sight.Paint;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.sim.SimulatedHome;
import org.maestro.sim.drivers.DriverFactory;
import org.maestro.sim.drivers.SimulatedCamera;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Course;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SimulationException;
import org.maestro.sim.world.Looks;
import org.maestro.sim.world.World;

/**
 * Sets a thing down at places in view of a camera in more and more light, and counts what the
 * pictures show. Each light is the same all over the home; nothing else stands in it. One thread.
 */
public final class CameraCalibration implements AutoCloseable {

  private static final int FRAMES = 10;
  private static final double DARKEST_LUX = 0.1;
  private static final double FIT_LUX = 500;
  private static final double BRIGHTEST_LUX = 100_000;
  private static final int LEVELS = 24;
  private static final int MILLIS = 1000;
  private static final double GRID_METRES = 0.1;
  private static final Position OUTSIDE = new Position(-1000, -1000, 0);

  /** Nearer than this it is the thing itself that was seen; metres. */
  private static final double THERE_METRES = 0.3;

  private final String device;
  private final String thing;
  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final SimulatedHome simulated;
  private final SimulatedCamera camera;
  private final Position lens;
  private final Random chance;

  private int found;
  private double squares;
  private double offsets;

  /**
   * @param scene of which the sky counts, and where devices stand
   * @param device one of {@link #cameras}
   * @param thing one of {@link #things}
   * @param seed of the places and of all noise
   * @throws SimulationException when there is no such camera, or the scene lacks what the home's
   *     devices need
   */
  public CameraCalibration(
      Home home,
      Scene scene,
      String device,
      String thing,
      PhysicalParameters parameters,
      long seed) {
    this.device = device;
    this.thing = thing;
    this.simulated =
        SimulatedHome.start(
            new SimulatedHome.Setup(
                    home,
                    bare(home, scene, thing),
                    clock,
                    seed,
                    bus::client,
                    "calibration",
                    new DescriptionWriter(home)::write)
                .only(Set.of(device))
                .with(parameters.with(Map.of("world.camera.fromPixels", "true"))));
    this.camera =
        simulated
            .drivers(device)
            .find(Camera.class)
            .filter(SimulatedCamera.class::isInstance)
            .map(SimulatedCamera.class::cast)
            .orElseThrow(
                () -> new SimulationException("The device %s is no camera.".formatted(device)));
    this.chance = new Random(seed);
    Pose pose = camera.pose();
    this.lens = new Position(pose.x(), pose.y(), pose.z());
  }

  /** Ids of the cameras that hang in one place, in the home's order. */
  public static List<String> cameras(Home home) {
    return SimulatedHome.inDeclaredOrder(home).stream()
        .filter(device -> device.driver().filter(DriverFactory.FIXED_CAMERAS::contains).isPresent())
        .map(Device::id)
        .toList();
  }

  /** Names of all with a colour that are no devices, the smallest first. */
  public static List<String> things(Home home) {
    return looks(home).entrySet().stream()
        .filter(look -> !home.devices().containsKey(look.getKey()))
        .sorted(Comparator.comparingDouble(look -> look.getValue().size().outline()))
        .map(Map.Entry::getKey)
        .toList();
  }

  private static Map<String, Appearance> looks(Home home) {
    return new Looks(home, new Scene("empty", Map.of())).known();
  }

  /**
   * The scene's sky and where devices stand, without lamps that shine and without what happens of
   * its own accord. The thing stands outside at first, and all others are grey, so that nothing
   * looks like it.
   */
  private static Scene bare(Home home, Scene scene, String thing) {
    Map<String, Scene.Entry> entries = new TreeMap<>();
    scene
        .entries()
        .forEach(
            (name, entry) ->
                entry
                    .position()
                    .filter(place -> home.devices().containsKey(name))
                    .ifPresent(place -> entries.put(name, Scene.Entry.NOTHING.at(place))));
    for (String name : looks(home).keySet()) {
      entries.put(name, Scene.Entry.NOTHING.at(OUTSIDE).in(Paint.GREY));
    }
    entries.put(thing, Scene.Entry.NOTHING.at(OUTSIDE));
    return new Scene("bare", entries, scene.sky(), Map.of(), Course.NOTHING, Map.of());
  }

  /**
   * Carries it out; it takes some ten seconds of a processor for each place.
   *
   * @param count how many places, at least one
   * @throws SimulationException when the camera sees no floor
   */
  public Calibrated carriedOut(int count) {
    List<Position> places = places(count);
    double nearest = Double.POSITIVE_INFINITY;
    double farthest = 0;
    for (Position place : places) {
      nearest = Math.min(nearest, lens.distance(place));
      farthest = Math.max(farthest, lens.distance(place));
    }
    List<LightLevel> dark = levels(places, DARKEST_LUX, FIT_LUX);
    List<LightLevel> bright = levels(places, FIT_LUX, BRIGHTEST_LUX);
    light(FIT_LUX);
    put(OUTSIDE);
    int nothing = look().map(Camera.Look::detections).orElse(0);
    return new Calibrated(
        device,
        thing,
        places.size(),
        nearest,
        farthest,
        dark,
        bright,
        FRAMES,
        nothing,
        found == 0 ? 0 : Math.sqrt(squares / (2 * found)),
        found == 0 ? 0 : offsets / found);
  }

  private List<Position> places(int count) {
    List<Position> inView = new ArrayList<>();
    for (Area area : simulated.world().building().map().areas()) {
      area.outline().samples(GRID_METRES).stream()
          .map(Position::onFloor)
          .filter(camera::sees)
          .forEach(inView::add);
    }
    if (inView.isEmpty()) {
      throw new SimulationException("The camera %s sees no floor.".formatted(device));
    }
    Collections.shuffle(inView, chance);
    return inView.subList(0, Math.min(count, inView.size()));
  }

  /** From one light to the other in equal ratios. */
  private List<LightLevel> levels(List<Position> places, double from, double to) {
    List<LightLevel> levels = new ArrayList<>();
    for (int i = 0; i <= LEVELS; i++) {
      levels.add(level(places, from * Math.pow(to / from, (double) i / LEVELS)));
    }
    return levels;
  }

  private LightLevel level(List<Position> places, double ambient) {
    light(ambient);
    double lux = 0;
    int shown = 0;
    int elsewhere = 0;
    for (Position place : places) {
      put(place);
      lux += simulated.world().lux(place) / places.size();
      Optional<Camera.Look> look = look();
      Optional<Position> seen = look.flatMap(Camera.Look::position);
      if (seen.filter(other -> other.distance(place) <= THERE_METRES).isPresent()) {
        shown += look.get().detections();
        measure(place, seen.get());
      } else {
        elsewhere += look.map(Camera.Look::detections).orElse(0);
      }
    }
    return new LightLevel(lux, places.size() * FRAMES, shown, elsewhere);
  }

  private void measure(Position place, Position seen) {
    double offset = seen.distance(place);
    found++;
    offsets += offset;
    squares += Math.pow(offset / lens.distance(place), 2);
  }

  private void light(double ambient) {
    World world = simulated.world();
    world.building().map().areas().forEach(area -> world.setAmbient(area.name(), ambient));
  }

  private void put(Position place) {
    World world = simulated.world();
    world.whereabouts().put(world.whereabouts().body(thing).at(place));
  }

  /** Empty when it cannot be said. */
  private Optional<Camera.Look> look() {
    AtomicReference<Camera.Look> look = new AtomicReference<>();
    clock.schedule(
        Duration.ZERO,
        device,
        () ->
            camera.look(
                new Target(thing, Map.of()),
                FRAMES,
                new Camera.Listener() {
                  @Override
                  public void looked(Camera.Look seen) {
                    look.set(seen);
                  }

                  @Override
                  public void failed(String reason) {
                    // no frame shows it for sure
                  }
                }));
    clock.run(Duration.ofMillis((long) (MILLIS * (FRAMES / camera.frameRate() + 1))));
    return Optional.ofNullable(look.get());
  }

  @Override
  public void close() {
    simulated.close();
  }
}
