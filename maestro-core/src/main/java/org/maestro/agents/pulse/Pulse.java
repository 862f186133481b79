package org.maestro.agents.pulse;

import jade.core.ServiceHelper;
import java.util.List;
import java.util.SortedMap;
import java.util.function.Consumer;
import org.maestro.rats.time.Clock;

/** The heartbeats of an agent's container, as an agent of it reaches them. Any thread may call. */
public interface Pulse extends ServiceHelper {

  /**
   * From now on the agent is looked at, and with the first one its container gives signs of life.
   *
   * @param name the agent's local name
   * @param tell has the agent do something on its own thread
   */
  void enlist(String name, Consumer<Runnable> tell, Clock clock);

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

  /** What is known of each container; empty where nobody watches. */
  SortedMap<String, Condition> containers();
}
