package org.maestro.bench;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.maestro.hal.Position;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.sim.SimulatedHome;
import org.maestro.sim.scene.Scene;

/**
 * A simulated home whose devices all work, without any platform: cameras look and sensors measure
 * all the time, lamps are turned up and down, and robots carry things from zone to zone. For one
 * thread.
 */
final class BusyWorld implements AutoCloseable {
  private static final String SITE = "bench-sim";
  private static final Duration TIMEOUT = Duration.ofMinutes(10);
  private static final Duration OPENING = Duration.ofSeconds(1);
  private static final Duration BETWEEN_LEVELS = Duration.ofSeconds(5);

  private final SteppedClock clock = new SteppedClock();
  private final Home home;
  private final List<String> things;
  private final List<String> zones;
  private final SimulatedHome simulated;
  private final BusLink link;
  private int robots;
  private int carried;

  BusyWorld(Home home, Scene scene, long seed) {
    this.home = home;
    this.things = ofClass("Item");
    this.zones = ofClass("Zone");
    InProcessBus bus = new InProcessBus(clock);
    simulated =
        SimulatedHome.start(
            new SimulatedHome.Setup(
                home, scene, clock, seed, bus::client, SITE, new DescriptionWriter(home)::write));
    link = BusLink.connect("bench", SITE, bus.client("bench"), clock);
    clock.run(OPENING);
    home.devices().values().forEach(this::employ);
  }

  private List<String> ofClass(String name) {
    return home.individuals().values().stream()
        .filter(individual -> individual.classes().contains(name))
        .map(individual -> individual.name())
        .toList();
  }

  private void employ(Device device) {
    if (offers(device, "observeObject")) {
      call(device.id(), "observeObject", Map.of("object", pointer(things.get(0))), ended -> {});
    } else if (offers(device, "measureIllumination")) {
      call(device.id(), "measureIllumination", Map.of(), ended -> {});
    } else if (offers(device, "adjustLight")) {
      adjust(device.id(), 1);
    } else if (offers(device, "pick")) {
      carry(device.id(), things.get(robots % things.size()), robots);
      robots++;
    }
  }

  private static boolean offers(Device device, String feature) {
    return device.features().stream().anyMatch(type -> type.name().equals(feature));
  }

  private void adjust(String lamp, double level) {
    call(
        lamp,
        "adjustLight",
        Map.of("level", level),
        ended -> clock.schedule(BETWEEN_LEVELS, lamp, () -> adjust(lamp, level == 1 ? 0.5 : 1)));
  }

  /** Picks a thing up and brings it somewhere, for ever; where that fails it drives on. */
  private void carry(String robot, String thing, int round) {
    call(
        robot,
        "pick",
        Map.of("object", pointer(thing)),
        picked -> {
          if (picked.outcome() == Outcome.SUCCEEDED) {
            bring(robot, thing, round);
          } else {
            String next = things.get((round + 1) % things.size());
            String zone = zones.get((round + 1) % zones.size());
            call(
                robot,
                "move",
                Map.of("to", pointer(zone)),
                moved -> clock.schedule(OPENING, robot, () -> carry(robot, next, round + 1)));
          }
        });
  }

  /** Places it in the next zone where it can be placed; somebody looks after batteries. */
  private void bring(String robot, String thing, int round) {
    call(
        robot,
        "place",
        Map.of("object", pointer(thing), "target", pointer(zones.get(round % zones.size()))),
        placed -> {
          boolean done = placed.outcome() == Outcome.SUCCEEDED;
          carried += done ? 1 : 0;
          simulated.world().charge(robot, 1);
          clock.schedule(
              OPENING,
              robot,
              () -> {
                if (done) {
                  carry(robot, thing, round + 1);
                } else {
                  bring(robot, thing, round + 1);
                }
              });
        });
  }

  private Map<String, Object> pointer(String name) {
    Map<String, Object> pointer = new LinkedHashMap<>();
    pointer.put("ref", Objects.requireNonNull(home.individuals().get(name)).iri());
    Optional<Position> place = simulated.world().position(name);
    place.ifPresent(at -> pointer.put("position", List.of(at.x(), at.y(), at.z())));
    return pointer;
  }

  private interface Ending {
    void ended(Result result);
  }

  private void call(String member, String feature, Map<String, Object> parameters, Ending ending) {
    link.call(
        member,
        feature,
        parameters,
        TIMEOUT,
        Optional.empty(),
        new RatsLink.CallListener() {
          @Override
          public void progressed(Progress progress) {}

          @Override
          public void observed(Observation observation) {}

          @Override
          public void ended(Result result) {
            ending.ended(result);
          }
        });
  }

  int devices() {
    return simulated.devices().size();
  }

  /** How many things were carried to another zone. */
  int carried() {
    return carried;
  }

  /** Lets so much simulated time pass. */
  void run(Duration time) {
    clock.run(time);
  }

  @Override
  public void close() {
    link.close();
    simulated.close();
    clock.run(OPENING);
  }
}
