package org.maestro.platform.hosts;

import java.util.Collection;
import java.util.Comparator;
import java.util.Optional;
import org.maestro.deployment.Provision;

/** The placement of agents: which host gets one. */
public final class Placing {
  private Placing() {}

  /**
   * A host that is alive.
   *
   * @param own it is the process of the platform itself, which is there as long as anybody asks
   * @param agents that run there already
   */
  public record Host(String name, Provision provides, boolean own, int agents) {}

  /**
   * The host that fits: the platform's own process first, as nobody has to be asked there, then the
   * one with the fewest agents, then by name.
   */
  public static Optional<Host> choose(Provision needed, Collection<Host> hosts) {
    return hosts.stream()
        .filter(host -> host.provides().lacks(needed).isEmpty())
        .min(
            Comparator.comparing((Host host) -> !host.own())
                .thenComparing(Host::agents)
                .thenComparing(Host::name));
  }
}
