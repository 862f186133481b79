package org.maestro.agents.pulse;

import jade.core.ServiceHelper;
import java.util.List;
import java.util.function.Consumer;
import org.maestro.rats.time.Clock;

/** The heartbeats of an agent's container, as an agent of it reaches them. Any thread may call. */
public interface Pulse extends ServiceHelper {

  /**
   * From now on the agent is looked at, and with the first one its container gives signs of life.
   *
   * @param name the agent's local name
   * @param tell has the agent do something on its own thread
   * @param forsake told when another takes its place as it hangs: from then on it must do nothing
   */
  void enlist(String name, Consumer<Runnable> tell, Runnable forsake, Clock clock);

  /** The agent ends as it should. */
  void leave(String name);

  /**
   * Whether the container has not been heard of for so long that another may act in its place. What
   * is asked of an agent then must not be begun.
   */
  boolean isCutOff();

  /**
   * Told once, on the clock's thread, when the platform has given this container up or cannot be
   * reached for long: whoever wants to go on has to join again.
   */
  void whenGivenUp(Runnable listener);

  /** Watches over all containers. In the main container only, once. */
  void watch(Clock clock, HeartbeatSettings settings, Watcher watcher);

  /**
   * Where a container's process listens, {@code host:port}; empty when it is this process, or
   * nothing is known of it.
   */
  List<String> addresses(String container);

  /**
   * Takes an agent that hangs out of its container, so that another can begin under its name. Waits
   * for JADE. In the main container only.
   *
   * @throws IllegalStateException when the container cannot be asked
   */
  void end(String container, String agent);

  /** What is known of containers and agents; of none where nobody watches. */
  Signs signs();
}
