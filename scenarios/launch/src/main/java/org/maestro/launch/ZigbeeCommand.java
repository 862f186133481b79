package org.maestro.launch;

import java.net.URI;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.Callable;
import org.maestro.assembly.HomeLamps;
import org.maestro.rats.gateway.ZigbeeBridge;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** The lamps behind a ZigBee gateway, as members of a site. */
@Command(
    name = "zigbee",
    description =
        "Present the lamps of a zigbee2mqtt gateway as lamps of a home, until Ctrl-C. A lamp stands"
            + " for the device of its friendly name, unless --lamp says for which.")
final class ZigbeeCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Parameters(paramLabel = "HOME.ttl", description = "A home file, or a shipped home: bob, arena.")
  private String home;

  @Mixin private SiteOptions options;

  @Option(
      names = "--gateway",
      paramLabel = "URI",
      required = true,
      description = "The broker of zigbee2mqtt, tcp://HOST:PORT.")
  private String gateway;

  @Option(
      names = "--base",
      paramLabel = "TOPIC",
      defaultValue = "zigbee2mqtt",
      description = "Its base topic; default ${DEFAULT-VALUE}.")
  private String base;

  @Option(
      names = "--lamp",
      paramLabel = "NAME=ID",
      description = "The lamp of this friendly name is that device of the home; may be repeated.")
  private Map<String, String> lamps = new LinkedHashMap<>();

  @Override
  public Integer call() throws InterruptedException {
    HomeLamps role = role();
    URI zigbee = Endpoint.broker(gateway);
    SiteOptions.Found site = options.join(role.ids().get(0));
    try (PacedClock clock = new PacedClock(1);
        ZigbeeBridge bridge =
            ZigbeeBridge.start(
                base,
                new PahoTransport(zigbee, site.name() + "-zigbee"),
                new ZigbeeBridge.Site(site.name(), site.bus().transports(), site.bus().policy()),
                role,
                clock)) {
      UntilStopped.run(
          spec.commandLine().getOut(),
          "Lamps of %s that may be %s join %s."
              .formatted(zigbee, String.join(", ", role.ids()), site.broker()),
          bridge::close);
    }
    return ExitCode.DONE;
  }

  private HomeLamps role() {
    try {
      return new HomeLamps(Shipped.home(home), lamps);
    } catch (IllegalArgumentException unfit) {
      throw CommandException.badInput(unfit);
    }
  }
}
