package org.maestro.sim;

import java.time.Duration;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.maestro.device.DeviceMember;
import org.maestro.device.Nameplate;
import org.maestro.hal.Camera;
import org.maestro.hal.Drivers;
import org.maestro.hal.Photo;
import org.maestro.hal.ShutterDrive;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.home.Windows;
import org.maestro.rats.member.CallPolicy;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Transport;
import org.maestro.sim.drivers.DriverFactory;
import org.maestro.sim.drivers.FacePages;
import org.maestro.sim.drivers.SimulatedCamera;
import org.maestro.sim.life.Life;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Course;
import org.maestro.sim.scene.Saying;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.ScriptedFault;
import org.maestro.sim.scene.SimulationException;
import org.maestro.sim.world.FloorMap;
import org.maestro.sim.world.Walks;
import org.maestro.sim.world.World;

/**
 * A home whose devices are simulated: one world, and one RATS member for each device that has a
 * driver, started in declared order ({@code maestro:order}). A device that dies in the world leaves
 * the bus without goodbye; one that is revived joins it anew. Any thread may call it.
 */
public final class SimulatedHome implements AutoCloseable {

  private static final String LISTENER = "Listener";
  private static final String ROOM = "Room";

  private final Setup setup;
  private final World world;
  private final Map<String, Drivers> driversOf;
  private final LivingMembers members;
  private final FaultRunner faults;
  private final FacePages pages = new FacePages();

  /**
   * The parts and parameters of a simulated home.
   *
   * @param seed of all chance; a device's share depends on its place in the declared order, not on
   *     its name
   * @param transports makes a transport, not yet open, for a member's id
   * @param site name of the site on the bus
   * @param descriptions writes the document that a member publishes
   * @param bus within the process, for faults that disturb it
   * @param only which devices are run here; the others are not on the bus, though lamps among them
   *     give their light
   */
  public record Setup(
      Home home,
      Scene scene,
      Clock clock,
      long seed,
      Function<String, Transport> transports,
      String site,
      Function<Device, String> descriptions,
      Predicate<String> only,
      PhysicalParameters parameters,
      CallPolicy policy,
      Optional<InProcessBus> bus) {

    /** All devices, with the usual physics, on an open site. */
    public Setup(
        Home home,
        Scene scene,
        Clock clock,
        long seed,
        Function<String, Transport> transports,
        String site,
        Function<Device, String> descriptions) {
      this(
          home,
          scene,
          clock,
          seed,
          transports,
          site,
          descriptions,
          id -> true,
          PhysicalParameters.standard(),
          CallPolicy.OPEN,
          Optional.empty());
    }

    public Setup only(Set<String> ids) {
      return changed(ids::contains, parameters, policy, bus);
    }

    public Setup with(PhysicalParameters other) {
      return changed(only, other, policy, bus);
    }

    /** On a site with rules of who may call what. */
    public Setup withPolicy(CallPolicy rules) {
      return changed(only, parameters, rules, bus);
    }

    /** With a bus within the process, which faults may disturb. */
    public Setup on(InProcessBus disturbed) {
      return changed(only, parameters, policy, Optional.of(disturbed));
    }

    private Setup changed(
        Predicate<String> which,
        PhysicalParameters physics,
        CallPolicy rules,
        Optional<InProcessBus> disturbed) {
      return new Setup(
          home,
          scene,
          clock,
          seed,
          transports,
          site,
          descriptions,
          which,
          physics,
          rules,
          disturbed);
    }
  }

  private SimulatedHome(Setup setup) {
    this.setup = setup;
    this.world =
        new World(setup.home(), setup.scene(), setup.clock(), setup.seed(), setup.parameters());
    this.driversOf = furnished();
    this.members = new LivingMembers(setup, described());
    this.faults =
        new FaultRunner(
            setup.home(),
            world,
            setup.clock(),
            new Random(~setup.seed()),
            members::link,
            setup.bus());
  }

  /**
   * Builds the world and starts the members; they are ready some messages later.
   *
   * @throws SimulationException when home or scene lack what the simulation needs
   * @throws org.maestro.device.tasks.DeviceSetupException when a device offers what its driver
   *     cannot do
   */
  public static SimulatedHome start(Setup setup) {
    SimulatedHome simulated = new SimulatedHome(setup);
    simulated.devices().stream().filter(simulated.world::isAlive).forEach(simulated.members::start);
    simulated.world.listen(simulated.members::follow);
    simulated.begin(setup.scene().course());
    return simulated;
  }

  private void begin(Course course) {
    course.faults().forEach((subject, all) -> all.forEach(fault -> faults.begin(subject, fault)));
    Walks walks = new Walks(world, setup.clock());
    course.walks().forEach(walks::start);
    Life life = new Life(world, setup.clock(), setup.seed());
    course.roams().forEach(life::begin);
    course.sayings().forEach((person, all) -> all.forEach(saying -> begin(person, saying)));
  }

  private void begin(String person, Saying saying) {
    world.later(
        person, saying.at().toNanos() / 1e9, () -> world.talk().say(person, saying.words()));
  }

  public World world() {
    return world;
  }

  /**
   * Lets a fault happen, counted from now on: such as {@code ScriptedFault.parse("every 60 drop")}.
   *
   * @param subject the device, thing, zone or door to which it happens; empty for the home itself
   * @throws SimulationException when this cannot happen to it
   */
  public void let(String subject, ScriptedFault fault) {
    faults.begin(subject, fault);
  }

  /** Ids of the devices run here, in declared order. */
  public List<String> devices() {
    return members.ids();
  }

  /**
   * The drivers of a device, to use it without the bus. Their commands come from the clock's
   * thread.
   *
   * @throws SimulationException when it is not run here
   */
  public Drivers drivers(String device) {
    return Optional.ofNullable(driversOf.get(device))
        .orElseThrow(
            () ->
                new SimulationException(
                    "There is no device %s here; there are %s.".formatted(device, devices())));
  }

  /**
   * What a camera shows now; it takes no time, and the run goes on as without it.
   *
   * @throws SimulationException when there is no such camera
   */
  public Photo photo(String camera) {
    return drivers(camera)
        .find(Camera.class)
        .filter(SimulatedCamera.class::isInstance)
        .map(SimulatedCamera.class::cast)
        .orElseThrow(() -> new SimulationException("The device " + camera + " is no camera."))
        .photo();
  }

  /**
   * The time below which nobody could bring the thing next to the target, with things where they
   * are now.
   *
   * @throws SimulationException when one of them is nowhere, or there is no way
   */
  public Duration lowerBound(String robot, String thing, String target) {
    return new LowerBound(world, setup.parameters()).bringNextTo(robot, thing, target);
  }

  /**
   * Has faces that pages draw know whether there is one that does; until then somebody is taken to
   * look at each.
   *
   * @param isShown whether a page shows the face of that device now; any thread may ask, and it
   *     answers at once
   */
  public void facesAreShownBy(Predicate<String> isShown) {
    pages.become(isShown);
  }

  /** All members leave the bus for good. */
  @Override
  public void close() {
    members.close();
    world.end();
  }

  /** Drivers of the devices that are run here, in declared order; all devices get their seeds. */
  private Map<String, Drivers> furnished() {
    DriverFactory factory =
        new DriverFactory(
            world,
            setup.scene(),
            setup.clock(),
            setup.parameters(),
            new Windows(setup.home()),
            persons(),
            pages);
    Map<String, Drivers> all = new LinkedHashMap<>();
    Random seeds = new Random(setup.seed());
    for (Device device : inDeclaredOrder(setup.home())) {
      long seed = seeds.nextLong();
      device
          .driver()
          .map(key -> factory.drivers(device, key, seed))
          .filter(this::isFitted)
          .filter(drivers -> setup.only().test(device.id()))
          .ifPresent(drivers -> all.put(device.id(), drivers));
    }
    return all;
  }

  /** Who hears what is said and is no room. */
  private Set<String> persons() {
    return setup.home().individuals().values().stream()
        .filter(one -> one.classes().contains(LISTENER) && !one.classes().contains(ROOM))
        .map(Individual::name)
        .collect(Collectors.toUnmodifiableSet());
  }

  private Map<String, DeviceMember> described() {
    Map<String, DeviceMember> described = new LinkedHashMap<>();
    for (Device declared : inDeclaredOrder(setup.home())) {
      Drivers drivers = driversOf.get(declared.id());
      if (drivers != null) {
        Device device = Nameplate.on(declared, drivers);
        String description = setup.descriptions().apply(device);
        described.put(declared.id(), DeviceMember.of(device, drivers, setup.clock(), description));
      }
    }
    return described;
  }

  private boolean isFitted(Drivers drivers) {
    return setup.parameters().shutters() || drivers.find(ShutterDrive.class).isEmpty();
  }

  /** The devices of a home, as it orders them. */
  public static List<Device> inDeclaredOrder(Home home) {
    return home.devices().values().stream()
        .sorted(
            Comparator.comparingDouble(
                    (Device device) ->
                        FloorMap.number(device.individual(), "order")
                            .orElse(Double.POSITIVE_INFINITY))
                .thenComparing(Device::id))
        .toList();
  }
}
