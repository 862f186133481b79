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
import org.maestro.deployment.Directory;

/** Keeps the directory as the platform's own manager of agents has it, and tells who ended. */
public final class PlatformEvents implements AgentManager.Listener {
  private final Directory directory;
  private final Supplier<Instant> now;
  private final Listener listener;

  /** A listener to the events of a platform. Told on a thread of JADE that must not be held up. */
  public interface Listener {
    /** An agent is there that was not, also one in the place of another. */
    void born(String agent);

    /** An agent ended, killed or with its container. */
    void died(String agent);

    void moved(String agent, String container);

    void containerGone(String container);
  }

  private PlatformEvents(Directory directory, Supplier<Instant> now, Listener listener) {
    this.directory = directory;
    this.now = now;
    this.listener = listener;
  }

  /** Begins with what is there already. */
  public static void watch(
      Host main, Directory directory, Supplier<Instant> now, Listener listener) {
    PlatformEvents events = new PlatformEvents(directory, now, listener);
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
    directory.left(event.getContainer().getName());
    listener.containerGone(event.getContainer().getName());
  }

  @Override
  public void bornAgent(PlatformEvent event) {
    String agent = event.getAgent().getLocalName();
    directory.born(agent, event.getContainer().getName(), now.get());
    listener.born(agent);
  }

  @Override
  public void deadAgent(PlatformEvent event) {
    directory.dead(event.getAgent().getLocalName());
    listener.died(event.getAgent().getLocalName());
  }

  @Override
  public void movedAgent(PlatformEvent event) {
    String agent = event.getAgent().getLocalName();
    String container = event.getNewContainer().getName();
    directory.moved(agent, container, now.get());
    listener.moved(agent, container);
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
