package org.maestro.platform.failover;

import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.maestro.agents.lives.AgentLives;
import org.maestro.agents.pulse.HeartbeatSettings;
import org.maestro.agents.pulse.Pulse;
import org.maestro.agents.pulse.Signs;
import org.maestro.platform.wires.Wires;
import org.maestro.rats.time.Clock;

/** The liveness of a platform's containers, by their signs of life. Any thread may call. */
public final class SignsOfLife {
  private final Clock clock;
  private final HeartbeatSettings settings;
  private final Wires wires;
  private final Supplier<Map<String, String>> containerByAgent;
  private final AgentLives lives;
  private volatile Optional<Pulse> heard = Optional.empty();

  /**
   * @param wires to containers of other processes, which are cut when one is lost
   * @param containerByAgent as they are at the time
   * @param lives is told who is doubted, trusted again, or hangs
   */
  public SignsOfLife(
      Clock clock,
      HeartbeatSettings settings,
      Wires wires,
      Supplier<Map<String, String>> containerByAgent,
      AgentLives lives) {
    this.clock = clock;
    this.settings = settings;
    this.wires = wires;
    this.containerByAgent = containerByAgent;
    this.lives = lives;
  }

  /** They can be heard from now on. */
  public void watch(Pulse pulse) {
    heard = Optional.of(pulse);
    pulse.watch(clock, settings, new FailureHandler(pulse, wires, containerByAgent, lives));
  }

  /** Takes an agent that hangs out of its container; see {@link Pulse#end}. */
  public void end(String container, String agent) {
    heard.ifPresent(pulse -> pulse.end(container, agent));
  }

  /** Of none on a stepped clock, on which nobody is watched. */
  public Signs signs() {
    return heard.map(Pulse::signs).orElseGet(Signs::none);
  }
}
