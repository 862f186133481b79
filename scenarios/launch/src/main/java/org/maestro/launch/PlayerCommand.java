package org.maestro.launch;

import java.net.InetSocketAddress;
import java.util.concurrent.Callable;
import org.maestro.assembly.PlayerRobot;
import org.maestro.assembly.SiteBus;
import org.maestro.device.tasks.DeviceSetupException;
import org.maestro.hal.player.PlayerBase;
import org.maestro.hal.player.PlayerConnection;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.PacedClock;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** A robot behind a Player server, as a member of a site. */
@Command(
    name = "player",
    description =
        "Present the base of a Player server as a robot of a home, until Ctrl-C. The robot knows the home's walls and not what stands on the floor.")
final class PlayerCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Parameters(
      paramLabel = "HOME.ttl",
      description = "A home file, or a shipped home: bob, exploration.")
  private String home;

  @Option(
      names = "--robot",
      paramLabel = "ID",
      required = true,
      description = "Which device of the home it is.")
  private String robot;

  @Option(
      names = "--server",
      paramLabel = "HOST:PORT",
      required = true,
      description = "The Player server; its usual port is 6665.")
  private String server;

  @Option(
      names = "--base",
      paramLabel = "NUMBER",
      defaultValue = "0",
      description = "Which of the server's position2d devices; default ${DEFAULT-VALUE}.")
  private int base;

  @Option(
      names = "--at",
      paramLabel = "\"X Y DEGREES\"",
      required = true,
      description = "Where the robot stands and looks now, in the home's frame.")
  private String at;

  @Mixin private SecurityOptions security;

  @Option(
      names = "--broker",
      paramLabel = "URI",
      required = true,
      description = "The site's MQTT 5 broker, tcp://HOST:PORT.")
  private String broker;

  @Option(
      names = "--site",
      paramLabel = "NAME",
      defaultValue = "maestro",
      description = "The platform's name; default ${DEFAULT-VALUE}.")
  private String site;

  @Override
  public Integer call() throws InterruptedException {
    Home loaded = Shipped.home(home);
    Device device = device(loaded);
    PlayerBase.Place place = place();
    Endpoint endpoint = Endpoint.parse(server);
    SiteBus bus = new SiteBus(Endpoint.broker(broker), site, security.files());
    bus.requireLetIn(robot);
    try (PacedClock clock = new PacedClock(1);
        PlayerConnection connection =
            PlayerConnection.open(new InetSocketAddress(endpoint.host(), endpoint.port()), base);
        PlayerRobot member =
            PlayerRobot.start(loaded, device, connection, place, site, bus, clock)) {
      UntilStopped.run(
          spec.commandLine().getOut(),
          "The robot behind %s is %s on %s.".formatted(server, robot, broker),
          member::close);
    } catch (DeviceSetupException unfit) {
      throw CommandException.badInput(unfit);
    }
    return ExitCode.DONE;
  }

  private Device device(Home loaded) {
    Device device = loaded.devices().get(robot);
    if (device == null) {
      throw CommandException.badInput(
          "The home has no device %s; it has %s."
              .formatted(robot, String.join(", ", loaded.devices().keySet())));
    }
    return device;
  }

  private PlayerBase.Place place() {
    String[] numbers = at.strip().split("\\s+");
    try {
      if (numbers.length == 3) {
        return new PlayerBase.Place(
            new Point2(Double.parseDouble(numbers[0]), Double.parseDouble(numbers[1])),
            Math.toRadians(Double.parseDouble(numbers[2])));
      }
    } catch (NumberFormatException e) {
      throw notAPlace();
    }
    throw notAPlace();
  }

  private CommandException notAPlace() {
    return CommandException.badInput(
        "\"%s\" is no place to stand; write metres and degrees, such as --at \"3 2 90\"."
            .formatted(at));
  }
}
