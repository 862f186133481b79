package org.maestro.launch;

import java.net.URI;
import java.net.URISyntaxException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import org.maestro.assembly.RosDevices;
import org.maestro.assembly.RosPart;
import org.maestro.device.tasks.DeviceSetupException;
import org.maestro.hal.ros.RosBridge;
import org.maestro.hal.ros.RosCamera;
import org.maestro.hal.ros.RosVersion;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.PacedClock;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** A robot, sensors and cameras behind a rosbridge server, as members of a site. */
@Command(
    name = "ros",
    description =
        "Present what stands behind a rosbridge server as devices of a home, until Ctrl-C: a"
            + " robot's base, light sensors and thermometers, cameras with a detector. Each joins"
            + " when it is first heard.")
final class RosCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Parameters(
      paramLabel = "HOME.ttl",
      description = "A home file, or a shipped home: bob, exploration.")
  private String home;

  @Option(
      names = "--server",
      paramLabel = "URI",
      required = true,
      description = "The rosbridge server, ws://HOST:PORT; its usual port is 9090.")
  private String server;

  @Option(
      names = "--ros",
      paramLabel = "VERSION",
      defaultValue = "2",
      description = "Whose types it has: 1 or 2; default ${DEFAULT-VALUE}.")
  private int version;

  @Mixin private RosRobotOptions robot;

  @Option(
      names = "--sensor",
      paramLabel = "ID=TOPIC",
      description =
          "Tells what that light sensor or thermometer measures (sensor_msgs/Illuminance,"
              + " sensor_msgs/Temperature); may be repeated.")
  private Map<String, String> sensors = new LinkedHashMap<>();

  @Option(
      names = "--camera",
      paramLabel = "ID=TOPIC",
      description =
          "Tells what the detector of that camera shows (vision_msgs/Detection3DArray); may be"
              + " repeated.")
  private Map<String, String> cameras = new LinkedHashMap<>();

  @Option(
      names = "--pictures",
      paramLabel = "ID=TOPIC",
      description =
          "Tells the pictures of that camera (sensor_msgs/CompressedImage); may be repeated.")
  private Map<String, String> pictures = new LinkedHashMap<>();

  @Option(
      names = "--class",
      paramLabel = "CLASS=THING",
      description =
          "What detectors call CLASS is that thing of the home; may be repeated. Others have its"
              + " name.")
  private Map<String, String> thingByClass = new LinkedHashMap<>();

  @Option(
      names = "--frame",
      paramLabel = "FRAME",
      defaultValue = "map",
      description = "What ROS calls the home's frame; default ${DEFAULT-VALUE}.")
  private String frame;

  @Mixin private SiteOptions options;

  @Override
  public Integer call() throws InterruptedException {
    Home loaded = Shipped.home(home);
    List<RosPart> parts = parts(loaded);
    URI uri = uri();
    RosVersion types = types();
    SiteOptions.Found site = options.join(parts.get(0).device().id());
    try (PacedClock clock = new PacedClock(1);
        RosBridge bridge = RosBridge.open(uri, types);
        RosDevices devices =
            RosDevices.start(loaded, bridge, parts, site.name(), site.bus(), clock)) {
      UntilStopped.run(
          spec.commandLine().getOut(),
          "What %s tells of %s joins %s."
              .formatted(server, String.join(", ", ids(parts)), site.broker()),
          devices::close);
    } catch (DeviceSetupException unfit) {
      throw CommandException.badInput(unfit);
    }
    return ExitCode.DONE;
  }

  private static List<String> ids(List<RosPart> parts) {
    return parts.stream().map(part -> part.device().id()).toList();
  }

  private List<RosPart> parts(Home loaded) {
    List<RosPart> parts = new ArrayList<>();
    robot.part(loaded).ifPresent(parts::add);
    sensors.forEach(
        (id, topic) -> parts.add(new RosPart.Sensor(HomeDevice.named(id, loaded), topic(topic))));
    cameras.forEach(
        (id, topic) ->
            parts.add(
                new RosPart.Camera(
                    HomeDevice.named(id, loaded),
                    new RosCamera.Topics(
                        topic(topic),
                        frame,
                        thingByClass,
                        Optional.ofNullable(pictures.get(id)).map(RosCommand::topic)))));
    if (parts.isEmpty()) {
      throw CommandException.badInput(
          "Name what stands behind the server: --robot ID, --sensor ID=TOPIC or --camera"
              + " ID=TOPIC.");
    }
    requireOneEach(parts);
    return parts;
  }

  private void requireOneEach(List<RosPart> parts) {
    Set<String> named = new TreeSet<>();
    for (String id : ids(parts)) {
      if (!named.add(id)) {
        throw CommandException.badInput("%s is named twice; a device is one part.".formatted(id));
      }
    }
    for (String id : pictures.keySet()) {
      if (!cameras.containsKey(id)) {
        throw CommandException.badInput(
            "--pictures names %s, which no --camera names.".formatted(id));
      }
    }
  }

  private URI uri() {
    try {
      URI uri = new URI(server);
      if (Set.of("ws", "wss").contains(String.valueOf(uri.getScheme()))
          && uri.getHost() != null
          && uri.getPort() < 65_536
          && uri.getFragment() == null) {
        return uri;
      }
    } catch (URISyntaxException e) {
      throw notAServer();
    }
    throw notAServer();
  }

  private CommandException notAServer() {
    return CommandException.badInput(
        "\"%s\" is no rosbridge server; write ws://HOST:PORT, such as ws://127.0.0.1:9090."
            .formatted(server));
  }

  private RosVersion types() {
    return switch (version) {
      case 1 -> RosVersion.ROS_1;
      case 2 -> RosVersion.ROS_2;
      default -> throw CommandException.badInput("--ros is 1 or 2, not %d.".formatted(version));
    };
  }

  /** Of a topic's whole name, by which servers answer. */
  static String topic(String name) {
    if (!name.matches("(/[A-Za-z][A-Za-z0-9_]*)+")) {
      throw CommandException.badInput(
          "\"%s\" is no topic; write its whole name, such as /odom.".formatted(name));
    }
    return name;
  }
}
