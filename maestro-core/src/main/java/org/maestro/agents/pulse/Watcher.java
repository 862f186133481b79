package org.maestro.agents.pulse;

import java.time.Duration;

/** Is told what becomes of containers and agents, on the clock's thread, which it must not hold. */
public interface Watcher {

  /**
   * @param silence since the last sign of life
   */
  void container(String name, Condition now, Duration silence);

  /**
   * @param agent its local name; its container gives signs of life
   * @param silence since it was last seen to work
   */
  void agent(String agent, Condition now, Duration silence);
}
