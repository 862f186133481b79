package org.maestro.launch;

import java.net.InetSocketAddress;
import java.util.concurrent.Callable;
import org.maestro.assembly.PlayerRobot;
import org.maestro.device.tasks.DeviceSetupException;
import org.maestro.hal.player.PlayerConnection;
import org.maestro.hal.wheels.Stance;
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
        "Present the base of a Player server as a robot of a home, until Ctrl-C. The robot knows"
            + " the home's walls and not what stands on the floor.")
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

  @Mixin private SiteOptions options;

  @Override
  public Integer call() throws InterruptedException {
    Home loaded = Shipped.home(home);
    Device device = HomeDevice.named(robot, loaded);
    Stance place = HomeDevice.standing(at);
    Endpoint endpoint = Endpoint.parse(server);
    SiteOptions.Found site = options.join(robot);
    try (PacedClock clock = new PacedClock(1);
        PlayerConnection connection =
            PlayerConnection.open(new InetSocketAddress(endpoint.host(), endpoint.port()), base);
        PlayerRobot member =
            PlayerRobot.start(loaded, device, connection, place, site.name(), site.bus(), clock)) {
      UntilStopped.run(
          spec.commandLine().getOut(),
          "The robot behind %s is %s on %s.".formatted(server, robot, site.broker()),
          member::close);
    } catch (DeviceSetupException unfit) {
      throw CommandException.badInput(unfit);
    }
    return ExitCode.DONE;
  }
}
