package org.maestro.sim;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.Predicate;
import org.maestro.device.DeviceMember;
import org.maestro.hal.Camera;
import org.maestro.hal.Drivers;
import org.maestro.hal.Photo;
import org.maestro.hal.ShutterDrive;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Windows;
import org.maestro.rats.member.CallPolicy;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Transport;
import org.maestro.sim.link.BadLink;

/**
 * A home whose devices are simulated: one world, and one RATS member for each device that has a
 * driver, started in declared order ({@code maestro:order}). A device that dies in the world leaves
 * the bus without goodbye; one that is revived joins it anew. Any thread may call it.
 */
public final class SimulatedHome implements AutoCloseable {

  private final Setup setup;
  private final World world;
  private final Map<String, DeviceMember> members = new LinkedHashMap<>();
  private final Map<String, Drivers> driversOf = new LinkedHashMap<>();
  private final Map<String, BadLink> links = new TreeMap<>();
  private final FaultRunner faults;
  private final Map<String, RatsMember> running = new LinkedHashMap<>();
  private boolean closed;

  /**
   * What a simulated home is made from.
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
    this.faults =
        new FaultRunner(
            setup.home(), world, setup.clock(), new Random(~setup.seed()), this::link, setup.bus());
  }

  /**
   * Builds the world and starts the members; they are ready some messages later.
   *
   * @throws SimulationException when home or scene lack what the simulation needs
   * @throws org.maestro.device.DeviceSetupException when a device offers what its driver cannot do
   */
  public static SimulatedHome start(Setup setup) {
    SimulatedHome simulated = new SimulatedHome(setup);
    simulated.furnish();
    simulated.members.keySet().stream()
        .filter(simulated.world::isAlive)
        .forEach(simulated::startMember);
    simulated.world.listen(simulated::follow);
    simulated.begin(setup.scene().course());
    return simulated;
  }

  private void begin(Course course) {
    course.faults().forEach((subject, all) -> all.forEach(fault -> faults.begin(subject, fault)));
    Walks walks = new Walks(world, setup.clock());
    course.walks().forEach(walks::start);
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
    return List.copyOf(members.keySet());
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

  /** All members leave the bus for good. */
  @Override
  public void close() {
    List<RatsMember> leaving;
    synchronized (this) {
      closed = true;
      leaving = new ArrayList<>(running.values());
      running.clear();
    }
    leaving.forEach(RatsMember::close);
    world.end();
  }

  private void furnish() {
    DriverFactory factory =
        new DriverFactory(
            world, setup.scene(), setup.clock(), setup.parameters(), new Windows(setup.home()));
    List<Device> inOrder = inDeclaredOrder(setup.home());
    Random seeds = new Random(setup.seed());
    for (Device device : inOrder) {
      long seed = seeds.nextLong();
      Optional<Drivers> drivers = device.driver().map(key -> factory.drivers(device, key, seed));
      if (drivers.isPresent() && isFitted(drivers.get()) && setup.only().test(device.id())) {
        driversOf.put(device.id(), drivers.get());
        members.put(
            device.id(),
            DeviceMember.of(
                device, drivers.get(), setup.clock(), setup.descriptions().apply(device)));
      }
    }
  }

  private boolean isFitted(Drivers drivers) {
    return setup.parameters().shutters() || drivers.find(ShutterDrive.class).isEmpty();
  }

  static List<Device> inDeclaredOrder(Home home) {
    return home.devices().values().stream()
        .sorted(
            Comparator.comparingDouble(
                    (Device device) ->
                        FloorMap.number(device.individual(), "order")
                            .orElse(Double.POSITIVE_INFINITY))
                .thenComparing(Device::id))
        .toList();
  }

  /** The link of a member, through all its lives. */
  private synchronized BadLink link(String id) {
    return links.computeIfAbsent(
        id,
        member ->
            new BadLink(
                member,
                setup.clock(),
                new Random(31 * setup.seed() + List.copyOf(members.keySet()).indexOf(member))));
  }

  private void startMember(String id) {
    DeviceMember member = members.get(id);
    RatsMember started =
        RatsMember.start(
            member.profile(),
            member.values(),
            link(id).over(setup.transports().apply(id)),
            setup.site(),
            setup.policy(),
            setup.clock());
    synchronized (this) {
      running.put(id, started);
    }
  }

  private void follow(WorldEvent event) {
    String subject = event.subject();
    if (event.kind() == WorldEvent.Kind.DIED) {
      removeRunning(subject).ifPresent(RatsMember::die);
    } else if (event.kind() == WorldEvent.Kind.REVIVED && isWanted(subject)) {
      startMember(subject);
    } else {
      findRunning(subject).ifPresent(this::tellChange);
    }
  }

  /** The change may have been made by any thread; the member belongs to the clock's. */
  private void tellChange(RatsMember member) {
    setup.clock().schedule(Duration.ZERO, member.id(), member::stateChanged);
  }

  private synchronized Optional<RatsMember> findRunning(String id) {
    return Optional.ofNullable(running.get(id));
  }

  private synchronized Optional<RatsMember> removeRunning(String id) {
    return Optional.ofNullable(running.remove(id));
  }

  private synchronized boolean isWanted(String id) {
    return !closed && members.containsKey(id) && !running.containsKey(id);
  }
}
