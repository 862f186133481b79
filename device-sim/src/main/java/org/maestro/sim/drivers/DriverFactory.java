package org.maestro.sim.drivers;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import org.maestro.device.navigation.SeenFloor;
import org.maestro.hal.Area;
import org.maestro.hal.Battery;
import org.maestro.hal.Camera;
import org.maestro.hal.ContentsReader;
import org.maestro.hal.DaylightSensor;
import org.maestro.hal.DimmableLamp;
import org.maestro.hal.DoorDrive;
import org.maestro.hal.Drivers;
import org.maestro.hal.Ear;
import org.maestro.hal.Face;
import org.maestro.hal.FaceMount;
import org.maestro.hal.GripperArm;
import org.maestro.hal.IlluminationSensor;
import org.maestro.hal.JammingGripper;
import org.maestro.hal.JammingHand;
import org.maestro.hal.Loudspeaker;
import org.maestro.hal.Microphone;
import org.maestro.hal.MobileBase;
import org.maestro.hal.PageFace;
import org.maestro.hal.PersonRecognition;
import org.maestro.hal.Position;
import org.maestro.hal.PresenceSensor;
import org.maestro.hal.Settings;
import org.maestro.hal.ShutterDrive;
import org.maestro.hal.SignalField;
import org.maestro.hal.Steering;
import org.maestro.hal.Surroundings;
import org.maestro.hal.Switch;
import org.maestro.hal.SwitchedLamp;
import org.maestro.hal.Thermometer;
import org.maestro.hal.Transmitter;
import org.maestro.hal.WallClock;
import org.maestro.hal.sight.Detector;
import org.maestro.hal.sight.Recollection;
import org.maestro.ontology.floor.Glass;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Windows;
import org.maestro.rats.time.Clock;
import org.maestro.sim.parameters.ArmData;
import org.maestro.sim.parameters.BaseData;
import org.maestro.sim.parameters.CameraData;
import org.maestro.sim.parameters.FaceData;
import org.maestro.sim.parameters.GripperData;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.parameters.RecognitionData;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneSky;
import org.maestro.sim.scene.SimulationException;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.Body;
import org.maestro.sim.world.FloorMap;
import org.maestro.sim.world.LampLight;
import org.maestro.sim.world.Likeness;
import org.maestro.sim.world.Photographer;
import org.maestro.sim.world.World;
import org.maestro.sl.Term;

/**
 * Makes simulated drivers for the driver keys of device descriptions, and puts the devices into the
 * world.
 */
public final class DriverFactory {

  private static final double USUAL_BEAM_DEGREES = 120;
  private static final double FULL_STRENGTH = 1;
  private static final double FULL_CHARGE = 1;
  private static final double SECONDS_PER_HOUR = 3600;
  private static final String CAMERA = "camera";
  private static final String TRUSTING_CAMERA = "trusting-camera";

  /** What stands higher is seen elsewhere than it is; metres. */
  private static final double ON_THE_FLOOR_METRES = 0.1;

  /** Keys of cameras that hang in one place. */
  public static final Set<String> FIXED_CAMERAS = Set.of(CAMERA, TRUSTING_CAMERA);

  private static final String LOCKED = "locked";
  private static final String TARGET = "target";

  private final World world;
  private final Scene scene;
  private final Clock clock;
  private final PhysicalParameters parameters;
  private final Windows windows;
  private final Set<String> robots = new TreeSet<>();
  private final SortedSet<String> persons;
  private final Photographer photographer;
  private final Recollection recollection;
  private final FacePages pages;

  /**
   * @param persons whom sensors that tell persons apart know
   * @param pages that draw faces
   */
  public DriverFactory(
      World world,
      Scene scene,
      Clock clock,
      PhysicalParameters parameters,
      Windows windows,
      Set<String> persons,
      FacePages pages) {
    this.world = world;
    this.scene = scene;
    this.clock = clock;
    this.parameters = parameters;
    this.windows = windows;
    this.persons = new TreeSet<>(persons);
    this.pages = pages;
    this.photographer = new Photographer(world, robots, parameters);
    this.recollection = new Recollection(inTheOpen(world));
  }

  /** What somebody has shown to the cameras when they were set up; assumed. */
  private static Map<String, Position> inTheOpen(World world) {
    Map<String, Position> shown = new TreeMap<>();
    for (String name : world.bodies()) {
      if (world.whereabouts().body(name).isInTheOpen()) {
        world
            .position(name)
            .filter(place -> place.z() < ON_THE_FLOOR_METRES)
            .ifPresent(place -> shown.put(name, place));
      }
    }
    return shown;
  }

  /**
   * @param key of the device's description
   * @param seed of the device's chance
   * @throws SimulationException when there is no such driver, or home and scene lack what it needs
   */
  public Drivers drivers(Device device, String key, long seed) {
    Actuator actuator = new Actuator(device.id(), world, clock, new Random(seed));
    return switch (key) {
      case "lamp" ->
          withSettings(
              device,
              actuator,
              lamp(device)
                  .with(DimmableLamp.class, new SimulatedLamp(actuator, parameters.lamp())));
      case "switched-lamp" ->
          lamp(device)
              .with(
                  DimmableLamp.class,
                  new SwitchedLamp(
                      new SimulatedSwitch(actuator, parameters.drives()),
                      parameters.lamp().whiteKelvin()));
      case CAMERA -> ceilingCamera(device, actuator, parameters.camera(), seed);
      case TRUSTING_CAMERA -> ceilingCamera(device, actuator, parameters.camera().trusting(), seed);
      case "light-sensor" ->
          Drivers.none().with(IlluminationSensor.class, fixedSensor(device, actuator));
      case "tsl2561" ->
          Drivers.none()
              .with(
                  IlluminationSensor.class,
                  new SimulatedTsl2561(actuator, parameters.sensor(), place(device)));
      case "presence-sensor" ->
          Drivers.none()
              .with(
                  PresenceSensor.class,
                  SimulatedPresenceSensor.start(
                      actuator, parameters.presence(), area(device), robots));
      case "recognising-camera" -> recognition(device, actuator, parameters.recognition(), true);
      case "phone-receiver" -> recognition(device, actuator, parameters.phone(), false);
      case "door" -> door(device, actuator);
      case "appliance" -> appliance(device, actuator);
      case "simulated-ear" ->
          Drivers.none()
              .with(
                  Ear.class, SimulatedEar.start(actuator, parameters.speech(), area(device).name()))
              .with(
                  Microphone.class,
                  SimulatedMicrophone.start(
                      actuator, parameters.speech(), area(device).name(), seed));
      case "loudspeaker" ->
          Drivers.none()
              .with(
                  Loudspeaker.class,
                  new SimulatedLoudspeaker(actuator, parameters.speech(), area(device).name()));
      case "thermostat" -> thermostat(device, actuator);
      case "thermometer" ->
          Drivers.none()
              .with(
                  Thermometer.class,
                  SimulatedThermometer.start(
                      actuator, parameters.thermometer(), area(device).name()));
      case "stocked-appliance" ->
          appliance(device, actuator)
              .with(ContentsReader.class, new SimulatedContentsReader(actuator, place(device)));
      case "clock" -> clock(device, actuator);
      case "shutter" -> shutter(device, actuator);
      case "mobile-robot" -> robot(device, actuator, Undercarriage::gliding);
      case "mobile-robot-with-fingers" ->
          robot(device, actuator, Undercarriage::gliding, DriverFactory::fingers);
      case "mecanum-robot" -> robot(device, actuator, DriverFactory::onMecanumWheels);
      case "differential-robot" -> robot(device, actuator, DriverFactory::onTwoWheels);
      case "exploring-robot" ->
          robot(device, actuator, DriverFactory::onTwoWheels)
              .with(Transmitter.class, new SimulatedTransmitter(actuator, parameters.signal()));
      case "signal-field" ->
          Drivers.none().with(SignalField.class, new SimulatedField(actuator, parameters.signal()));
      case "face" ->
          Drivers.none()
              .with(Face.class, new SimulatedFace(actuator, mount(device), FaceData.USUAL));
      case "face-page" ->
          Drivers.none()
              .with(
                  Face.class,
                  new PageFace(
                      device.id(),
                      mount(device),
                      () -> pages.show(device.id()),
                      actuator::after,
                      () -> actuator.tell(WorldEvent.Kind.FACED)));
      case "mobile-robot-with-camera" -> seeingRobot(device, actuator, seed);
      case "mobile-robot-with-sensors" ->
          seeingRobot(device, actuator, seed)
              .with(IlluminationSensor.class, sensorOnBoard(device, actuator));
      default ->
          throw new SimulationException(
              "The driver "
                  + key
                  + " of "
                  + device.id()
                  + " cannot be simulated; known are lamp, switched-lamp, camera, trusting-camera,"
                  + " light-sensor, tsl2561, presence-sensor, recognising-camera, phone-receiver,"
                  + " door, appliance, stocked-appliance, thermostat, thermometer, simulated-ear,"
                  + " loudspeaker, clock, shutter,"
                  + " mobile-robot, mobile-robot-with-camera, mobile-robot-with-sensors,"
                  + " mobile-robot-with-fingers,"
                  + " mecanum-robot, differential-robot, exploring-robot, signal-field, face,"
                  + " face-page.");
    };
  }

  /** Puts its light into the world; what dims or switches it is still lacking. */
  private Drivers lamp(Device device) {
    Scene.Entry entry = scene.of(device.id());
    OptionalDouble beam = FloorMap.number(device.individual(), "beamAngle");
    world
        .lighting()
        .put(
            device.id(),
            new LampLight(
                pose(device),
                number(device, "luminousIntensity"),
                beam.orElse(USUAL_BEAM_DEGREES),
                entry.strength().orElse(FULL_STRENGTH),
                entry.level().orElse(0)));
    return Drivers.none();
  }

  private Drivers ceilingCamera(Device device, Actuator actuator, CameraData kind, long seed) {
    Eye eye = Eye.fixed(pose(device), number(device, "viewAngle"));
    return Drivers.none().with(Camera.class, camera(device, actuator, kind, eye, seed));
  }

  /** A setting that was changed is the truth, whatever the home states of its devices. */
  private static double believed(Device device, String word, double set, double usual) {
    return set == usual ? Stated.number(device, word).orElse(set) : set;
  }

  private Camera camera(Device device, Actuator actuator, CameraData kind, Eye eye, long seed) {
    CameraData usual = CameraData.LIFECAM;
    CameraData data =
        kind.within(
            believed(device, "minimumLight", kind.minimumLux(), usual.minimumLux()),
            believed(device, "maximumLight", kind.maximumLux(), usual.maximumLux()));
    double frameRate = FloorMap.number(device.individual(), "frameRate").orElse(data.frameRate());
    Photographer.Resolution resolution =
        FloorMap.pair(device.individual(), "resolution")
            .map(pixels -> new Photographer.Resolution((int) pixels.x(), (int) pixels.y()))
            .orElse(new Photographer.Resolution(data.width(), data.height()));
    CameraData rated = data.atRate(frameRate);
    return new SimulatedCamera(
        actuator,
        rated,
        eye,
        light ->
            rated.fromPixels()
                ? inPictures(actuator, rated, eye, resolution)
                : new ModelledDetection(
                    actuator, new Likeness(rated, parameters.colour()), eye, light),
        (now, widest) ->
            photographer.take(
                eye.views().get().get(0), eye.viewDegrees(), resolution.within(widest), seed, now));
  }

  private Detection inPictures(
      Actuator actuator, CameraData data, Eye eye, Photographer.Resolution resolution) {
    return new PictureDetection(
        actuator,
        eye,
        new Detector(parameters.colour().tolerance(), !data.noticesGlare()),
        new PictureDetection.Darkroom(
            pose ->
                Photographer.lens(
                    pose, eye.viewDegrees(), resolution.within(data.detectionWidth())),
            lens -> photographer.light(lens, name -> isToBeSeen(actuator.device(), name))),
        world.looks().known(),
        recollection);
  }

  /** What is in a hand is covered by it, and no camera looks at what carries it. */
  private boolean isToBeSeen(String camera, String body) {
    return !body.equals(camera) && world.holder(body).isEmpty();
  }

  private Drivers appliance(Device device, Actuator actuator) {
    SimulatedAppliance appliance = settings(device, actuator);
    return Drivers.none().with(Switch.class, appliance).with(Settings.class, appliance);
  }

  /** An appliance that keeps the zone in which it stands as warm as its target says. */
  private Drivers thermostat(Device device, Actuator actuator) {
    SimulatedAppliance thermostat = settings(device, actuator);
    FloorMap.pose(device.individual(), "pose")
        .flatMap(pose -> world.building().map().areaAt(new Point2(pose.x(), pose.y())))
        .ifPresent(
            area ->
                world.climate().keep(area.name(), device.id(), () -> thermostat.number(TARGET)));
    return Drivers.none().with(Switch.class, thermostat).with(Settings.class, thermostat);
  }

  private SimulatedAppliance settings(Device device, Actuator actuator) {
    AtFirst first = AtFirst.of(device, scene);
    return new SimulatedAppliance(
        actuator, parameters.drives(), device.settings(), first.isOn(), first.settings());
  }

  private Drivers withSettings(Device device, Actuator actuator, Drivers drivers) {
    return device.settings().isEmpty()
        ? drivers
        : drivers.with(Settings.class, settings(device, actuator));
  }

  /** A door with a lock of its own is locked as that is set, any other as the home says. */
  private Drivers door(Device device, Actuator actuator) {
    boolean stated = Stated.truth(device, LOCKED);
    if (!device.settings().containsKey(LOCKED)) {
      return Drivers.none()
          .with(DoorDrive.class, new SimulatedDoor(actuator, parameters.drives(), () -> stated));
    }
    SimulatedAppliance lock = settings(device, actuator);
    BooleanSupplier locked = () -> new Term.Truth(true).equals(lock.values().get(LOCKED));
    return Drivers.none()
        .with(DoorDrive.class, new SimulatedDoor(actuator, parameters.drives(), locked))
        .with(Settings.class, lock);
  }

  private Drivers clock(Device device, Actuator actuator) {
    SceneSky sky =
        scene
            .sky()
            .orElseThrow(
                () ->
                    new SimulationException(
                        "The scene "
                            + scene.name()
                            + " does not say what time it is, which "
                            + device.id()
                            + " shows. Give the home scene:latitude, scene:dayOfYear and"
                            + " scene:solarTime."));
    Duration startedAt = Duration.ofSeconds(Math.round(sky.solarHours() * SECONDS_PER_HOUR));
    return Drivers.none().with(WallClock.class, SimulatedWallClock.start(actuator, startedAt));
  }

  private Drivers shutter(Device device, Actuator actuator) {
    Drivers drivers =
        Drivers.none()
            .with(ShutterDrive.class, new SimulatedShutter(actuator, parameters.drives()));
    List<Glass> shaded = windows.shadedBy(device.id()).stream().map(Windows.Window::glass).toList();
    return shaded.isEmpty() || scene.sky().isEmpty()
        ? drivers
        : drivers.with(
            DaylightSensor.class,
            SimulatedDaylightSensor.start(actuator, parameters.facade(), shaded));
  }

  private interface Chassis {
    MobileBase on(Undercarriage undercarriage, Actuator actuator);
  }

  private static MobileBase onMecanumWheels(Undercarriage undercarriage, Actuator actuator) {
    return undercarriage.onWheels(actuator, Undercarriage.Wheels.MECANUM);
  }

  private static MobileBase onTwoWheels(Undercarriage undercarriage, Actuator actuator) {
    return undercarriage.onWheels(actuator, Undercarriage.Wheels.DIFFERENTIAL);
  }

  /** An end effector at a robot's arm: it makes the drivers of both. */
  private interface Fitting {
    Drivers at(Device device, Actuator actuator, ArmData arm, Grasp grasp);
  }

  private Drivers jamming(Device device, Actuator actuator, ArmData arm, Grasp grasp) {
    GripperData data = parameters.gripper();
    double opening = believed(device, "grip", data.opening(), GripperData.USUAL.opening());
    JammingGripper gripper =
        new SimulatedJammingGripper(actuator, data.opening(opening), grasp, arm.power());
    return Drivers.none()
        .with(JammingGripper.class, gripper)
        .with(
            GripperArm.class,
            new SimulatedArm(
                actuator, arm, Stated.number(device, "height"), grasp, new JammingHand(gripper)));
  }

  private static Drivers fingers(Device device, Actuator actuator, ArmData arm, Grasp grasp) {
    double opening = Stated.number(device, "grip").orElse(SimulatedFingers.USUAL_OPENING_METRES);
    return Drivers.none()
        .with(
            GripperArm.class,
            new SimulatedArm(
                actuator,
                arm,
                Stated.number(device, "height"),
                grasp,
                new SimulatedFingers(actuator, grasp, arm.power(), opening)));
  }

  private Drivers robot(Device device, Actuator actuator, Chassis chassis) {
    return robot(device, actuator, chassis, this::jamming);
  }

  private Drivers robot(Device device, Actuator actuator, Chassis chassis, Fitting fitting) {
    Body body =
        world
            .whereabouts()
            .find(device.id())
            .orElseThrow(
                () ->
                    new SimulationException(
                        "The scene "
                            + scene.name()
                            + " does not say where "
                            + device.id()
                            + " stands. Give it a scene:position."));
    robots.add(device.id());
    Scene.Entry truth = scene.of(device.id());
    double speed = believed(device, "speed", parameters.base().speed(), BaseData.YOUBOT.speed());
    SeenFloor floor = seenFloor(device.id());
    Undercarriage undercarriage =
        new Undercarriage(
            device,
            parameters.wheels(),
            parameters.scanner(),
            parameters.base().atSpeed(truth.speed().orElse(speed)),
            floor::look);
    BaseData base = undercarriage.base();
    world.whereabouts().put(body.withRadius(base.radius()));
    double payload =
        believed(device, "payload", parameters.arm().payload(), ArmData.YOUBOT.payload());
    double reach = believed(device, "reach", parameters.arm().reach(), ArmData.YOUBOT.reach());
    ArmData arm = parameters.arm().lifting(truth.payload().orElse(payload)).reaching(reach);
    world
        .batteries()
        .put(device.id(), parameters.battery(), base.power(), truth.charge().orElse(FULL_CHARGE));
    Likeness likeness = new Likeness(parameters.camera(), parameters.colour());
    Drivers fitted =
        fitting
            .at(device, actuator, arm, new Grasp(actuator, arm, likeness))
            .with(Battery.class, SimulatedBattery.start(actuator, parameters.battery()))
            .with(Surroundings.class, floor);
    MobileBase moving = chassis.on(undercarriage, actuator);
    return (moving instanceof Steering front ? fitted.with(Steering.class, front) : fitted)
        .with(MobileBase.class, moving);
  }

  private SeenFloor seenFloor(String robot) {
    FloorMap map = world.building().map();
    return new SeenFloor(
        new SeenFloor.Plan(map.areas(), map.doors(), map::walls),
        new SimulatedRangeFinder(robot, world, parameters.scanner()),
        clock,
        Duration.ofNanos(Math.round(parameters.scanner().memorySeconds() * 1e9)));
  }

  private Drivers seeingRobot(Device device, Actuator actuator, long seed) {
    Eye eye = Eye.onBoard(actuator, parameters.turn(), number(device, "viewAngle"));
    return robot(device, actuator, Undercarriage::gliding)
        .with(Camera.class, camera(device, actuator, parameters.camera(), eye, seed));
  }

  private SimulatedSensor fixedSensor(Device device, Actuator actuator) {
    Position place = place(device);
    return new SimulatedSensor(actuator, parameters.sensor(), () -> place);
  }

  /** At its foot: light is meant on the floor. */
  private SimulatedSensor sensorOnBoard(Device device, Actuator actuator) {
    return new SimulatedSensor(
        actuator, parameters.sensor(), () -> world.position(device.id()).orElseThrow());
  }

  private Drivers recognition(
      Device device, Actuator actuator, RecognitionData data, boolean needsLight) {
    Area area = area(device);
    return Drivers.none()
        .with(
            PersonRecognition.class,
            SimulatedRecognition.start(
                actuator,
                data,
                area,
                persons,
                () -> !needsLight || world.lux(area.name()) >= parameters.camera().minimumLux()));
  }

  private Area area(Device device) {
    return world
        .building()
        .map()
        .areaAt(place(device).floor())
        .orElseThrow(
            () ->
                new SimulationException(
                    "The sensor %s stands in no zone. Give it a maestro:pose within one."
                        .formatted(device.id())));
  }

  /** Where nobody says which way a face looks, it looks along the x axis. */
  private static FaceMount mount(Device device) {
    return new FaceMount(place(device), pose(device).yaw());
  }

  private static Position place(Device device) {
    Pose pose = pose(device);
    return new Position(pose.x(), pose.y(), pose.z());
  }

  private static Pose pose(Device device) {
    return FloorMap.pose(device.individual(), "pose").orElseThrow(() -> lacking(device, "pose"));
  }

  private static double number(Device device, String property) {
    return FloorMap.number(device.individual(), property)
        .orElseThrow(() -> lacking(device, property));
  }

  private static SimulationException lacking(Device device, String property) {
    return new SimulationException(
        device.id()
            + " has no maestro:"
            + property
            + ", without which it cannot be simulated. Add it to the home file.");
  }
}
