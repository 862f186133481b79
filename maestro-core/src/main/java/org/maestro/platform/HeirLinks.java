package org.maestro.platform;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import org.maestro.rats.link.RatsLink;

/**
 * Links to the bus under the names of containers that are no more. Members know a call again by its
 * caller's name; an agent that takes over calls by that of the one before it, so that what was
 * under way is heard of, and not done twice. On a broker one connection has a name at a time, so
 * the one before it is shut out. Thread-safe.
 */
final class HeirLinks implements AutoCloseable {
  private static final String PREFIX = "container-";

  private final Function<String, Optional<RatsLink>> connect;
  private final Map<String, RatsLink> linkByController = new TreeMap<>();
  private boolean closed;

  /**
   * @param connect makes a link for a controller, unless nobody may use that name any more
   */
  HeirLinks(Function<String, Optional<RatsLink>> connect) {
    this.connect = connect;
  }

  /** What a container's link is called on the bus. */
  static String controller(String container) {
    return PREFIX + container;
  }

  /** The container whose link is called so; empty when it is no container's. */
  static Optional<String> container(String controller) {
    return Optional.of(controller)
        .filter(name -> name.startsWith(PREFIX))
        .map(name -> name.substring(PREFIX.length()));
  }

  /** Empty when nobody may use that name any more: what was called under it is not heard of. */
  synchronized Optional<RatsLink> of(String controller) {
    if (closed) {
      throw new PlatformStartException("The platform ends; nobody takes over " + controller + ".");
    }
    RatsLink known = linkByController.get(controller);
    if (known != null) {
      return Optional.of(known);
    }
    Optional<RatsLink> made = connect.apply(controller);
    made.ifPresent(link -> linkByController.put(controller, link));
    return made;
  }

  /** The controller is there again itself. */
  synchronized void letGo(String controller) {
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
