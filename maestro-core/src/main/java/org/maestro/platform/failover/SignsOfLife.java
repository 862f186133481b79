package org.maestro.platform.failover;

import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import org.maestro.agents.pulse.Condition;
import org.maestro.agents.pulse.HeartbeatSettings;
import org.maestro.agents.pulse.Pulse;
import org.maestro.agents.pulse.Watcher;
import org.maestro.rats.time.Clock;

/** The liveness of a platform's containers, by their signs of life. Any thread may call. */
public final class SignsOfLife {
  private final Clock clock;
  private final HeartbeatSettings settings;
  private final Function<Pulse, Watcher> watching;
  private volatile Optional<Pulse> heard = Optional.empty();

  /**
   * @param watching does what is to be done when containers and agents fall silent
   */
  public SignsOfLife(Clock clock, HeartbeatSettings settings, Function<Pulse, Watcher> watching) {
    this.clock = clock;
    this.settings = settings;
    this.watching = watching;
  }

  /** They can be heard from now on. */
  public void watch(Pulse pulse) {
    heard = Optional.of(pulse);
    pulse.watch(clock, settings, watching.apply(pulse));
  }

  /** Empty on a stepped clock, on which nobody is watched. */
  public SortedMap<String, Condition> containers() {
    return heard.map(Pulse::containers).orElseGet(TreeMap::new);
  }
}
