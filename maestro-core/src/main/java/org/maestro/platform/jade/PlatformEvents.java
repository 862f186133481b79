package org.maestro.platform.jade;

import jade.core.AID;
import jade.core.AgentManager;
import jade.core.ContainerID;
import jade.core.NotFoundException;
import jade.core.event.MTPEvent;
import jade.core.event.PlatformEvent;
import java.time.Instant;
import java.util.function.Supplier;
import org.maestro.agents.device.Host;
import org.maestro.agents.lives.AgentLives;
import org.maestro.deployment.Directory;

/**
 * Keeps the directory as the platform's own manager of agents has it, and tells of the agents'
 * lives. Called by a thread of JADE that must not be held up.
 */
final class PlatformEvents implements AgentManager.Listener {
  private final Directory directory;
  private final Supplier<Instant> now;
  private final AgentLives lives;

  private PlatformEvents(Directory directory, Supplier<Instant> now, AgentLives lives) {
    this.directory = directory;
    this.now = now;
    this.lives = lives;
  }

  /** Begins with what is there already. */
  static void watch(Host main, Directory directory, Supplier<Instant> now, AgentLives lives) {
    PlatformEvents events = new PlatformEvents(directory, now, lives);
    main.watch(events);
    AgentManager manager = main.manager().orElseThrow();
    for (ContainerID container : manager.containerIDs()) {
      events.joined(container);
      try {
        for (var all = manager.containerAgents(container).iterator(); all.hasNext(); ) {
          directory.born(((AID) all.next()).getLocalName(), container.getName(), now.get());
        }
      } catch (NotFoundException e) {
        directory.left(container.getName());
      }
    }
  }

  private void joined(ContainerID container) {
    directory.joined(container.getName(), address(container), now.get());
  }

  private static String address(ContainerID container) {
    return container.getPort() == null
        ? container.getAddress()
        : container.getAddress() + ":" + container.getPort();
  }

  @Override
  public void addedContainer(PlatformEvent event) {
    joined(event.getContainer());
  }

  @Override
  public void removedContainer(PlatformEvent event) {
    String container = event.getContainer().getName();
    directory.left(container);
    lives.tell(listener -> listener.containerGone(container));
  }

  @Override
  public void bornAgent(PlatformEvent event) {
    String agent = event.getAgent().getLocalName();
    directory.born(agent, event.getContainer().getName(), now.get());
    lives.tell(listener -> listener.agentBegins(agent));
  }

  @Override
  public void deadAgent(PlatformEvent event) {
    String agent = event.getAgent().getLocalName();
    directory.dead(agent);
    lives.tell(listener -> listener.agentDied(agent));
  }

  @Override
  public void movedAgent(PlatformEvent event) {
    String agent = event.getAgent().getLocalName();
    String container = event.getNewContainer().getName();
    directory.moved(agent, container, now.get());
    lives.tell(listener -> listener.agentArrives(agent, container));
  }

  @Override
  public void suspendedAgent(PlatformEvent event) {
    directory.becomes(event.getAgent().getLocalName(), "suspended", now.get());
  }

  @Override
  public void resumedAgent(PlatformEvent event) {
    directory.becomes(event.getAgent().getLocalName(), "active", now.get());
  }

  @Override
  public void frozenAgent(PlatformEvent event) {
    directory.becomes(event.getAgent().getLocalName(), "frozen", now.get());
  }

  @Override
  public void thawedAgent(PlatformEvent event) {
    directory.becomes(event.getAgent().getLocalName(), "active", now.get());
  }

  @Override
  public void addedMTP(MTPEvent event) {
    // Addresses are no part of these tables.
  }

  @Override
  public void removedMTP(MTPEvent event) {
    // Addresses are no part of these tables.
  }

  @Override
  public void messageIn(MTPEvent event) {
    // Mail is no part of these tables.
  }

  @Override
  public void messageOut(MTPEvent event) {
    // Mail is no part of these tables.
  }
}
