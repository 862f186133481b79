package org.maestro.platform.failover;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.rats.link.RatsLink;

/**
 * Links to the bus under the names of containers that are no more. Members know a call again by its
 * caller's name; an agent that takes over calls by that of the one before it, so that what was
 * under way is heard of, and not done twice. On a broker one connection has a name at a time, so
 * the one before it is shut out. Thread-safe.
 */
public final class TakeoverLinks implements AutoCloseable {
  private static final String PREFIX = "container-";

  private final OtherNames names;
  private final Map<String, RatsLink> linkByController = new TreeMap<>();
  private boolean closed;

  public TakeoverLinks(OtherNames names) {
    this.names = names;
  }

  /** What a container's link is called on the bus. */
  public static String controller(String container) {
    return PREFIX + container;
  }

  /** The container whose link is called so; empty when it is no container's. */
  public static Optional<String> container(String controller) {
    return Optional.of(controller)
        .filter(name -> name.startsWith(PREFIX))
        .map(name -> name.substring(PREFIX.length()));
  }

  /** Empty when nobody may use that name any more: what was called under it is not heard of. */
  public synchronized Optional<RatsLink> of(String controller) {
    if (closed) {
      throw new PlatformStartException("The platform ends; nobody takes over " + controller + ".");
    }
    return names.mayBeUsed(controller)
        ? Optional.of(linkByController.computeIfAbsent(controller, names::connect))
        : Optional.empty();
  }

  /** The controller is there again itself, or nobody may use its name any more. */
  public synchronized void letGo(String controller) {
    RatsLink link = linkByController.remove(controller);
    if (link != null) {
      link.close();
    }
  }

  @Override
  public synchronized void close() {
    closed = true;
    linkByController.values().forEach(RatsLink::close);
    linkByController.clear();
  }
}
