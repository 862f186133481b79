package org.maestro.platform;

import jade.wrapper.AgentContainer;
import jade.wrapper.ControllerException;
import jade.wrapper.PlatformController;
import jade.wrapper.PlatformEvent;
import java.util.function.Consumer;

/** Tells of each agent that ends anywhere on a platform, also with its process. */
final class AgentDeaths implements PlatformController.Listener {
  private final Consumer<String> listener;

  private AgentDeaths(Consumer<String> listener) {
    this.listener = listener;
  }

  /**
   * @param main the platform's main container
   * @param listener is told local names, on a thread of JADE that it must not hold up
   */
  static void watch(AgentContainer main, Consumer<String> listener) {
    try {
      main.getPlatformController().addPlatformListener(new AgentDeaths(listener));
    } catch (ControllerException e) {
      throw new PlatformStartException("JADE does not tell which agents end.", e);
    }
  }

  @Override
  public void deadAgent(PlatformEvent event) {
    String name = event.getAgentGUID();
    listener.accept(name.substring(0, name.lastIndexOf('@')));
  }

  @Override
  public void bornAgent(PlatformEvent event) {
    // Agents announce themselves.
  }

  @Override
  public void startedPlatform(PlatformEvent event) {
    // Nothing depends on it.
  }

  @Override
  public void suspendedPlatform(PlatformEvent event) {
    // Platforms are never suspended here.
  }

  @Override
  public void resumedPlatform(PlatformEvent event) {
    // Platforms are never suspended here.
  }

  @Override
  public void killedPlatform(PlatformEvent event) {
    // Who ends it knows.
  }
}
