package org.maestro.launch;

import org.maestro.assembly.SiteBus;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The site that devices of a process of their own join, as several commands take it. */
final class SiteOptions {
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
  private String name;

  /** As it was typed. */
  String broker() {
    return broker;
  }

  String name() {
    return name;
  }

  /**
   * Makes sure that the broker is there, and lets a member in.
   *
   * @param member one of those that are to join
   */
  SiteBus bus(String member) {
    SiteBus bus = new SiteBus(Endpoint.broker(broker), name, security.files());
    bus.requireLetIn(member);
    return bus;
  }
}
