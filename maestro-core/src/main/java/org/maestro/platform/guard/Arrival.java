package org.maestro.platform.guard;

import jade.core.Agent;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.util.Collection;
import java.util.Map;
import java.util.stream.Stream;
import org.maestro.agents.GenericAgent;

/**
 * An agent that arrives as bytes. Only classes of this process are looked for, and only those that
 * a generic agent is made of are let in; the time it takes is bounded.
 */
final class Arrival extends ObjectInputStream {
  private Arrival(byte[] bytes) throws IOException {
    super(new ByteArrayInputStream(bytes));
    enableResolveObject(true);
  }

  /**
   * @throws ClassNotFoundException when it is of a class that is not here
   * @throws IOException when it is no agent that may come, or none at all
   */
  static Agent of(byte[] bytes) throws IOException, ClassNotFoundException {
    try (Arrival in = new Arrival(bytes)) {
      in.setObjectInputFilter(SerialFilter.ofAgents());
      if (in.readObject() instanceof GenericAgent agent) {
        return agent;
      }
      throw new InvalidObjectException("it is no generic agent");
    } catch (StackOverflowError endless) {
      throw new InvalidObjectException("it contains itself");
    }
  }

  /**
   * Sets of sets take as long to hash as two to the power of their depth; nobody needs any. What
   * has been read is asked before it is put into anything.
   */
  @Override
  protected Object resolveObject(Object read) throws IOException {
    if (elements(read).anyMatch(Arrival::holdsOthers)) {
      throw new InvalidObjectException("it holds collections within collections");
    }
    return read;
  }

  private static Stream<?> elements(Object read) {
    if (read instanceof Collection<?> collection) {
      return collection.stream();
    }
    if (read instanceof Map<?, ?> map) {
      return Stream.concat(map.keySet().stream(), map.values().stream());
    }
    return Stream.empty();
  }

  private static boolean holdsOthers(Object element) {
    return element instanceof Collection || element instanceof Map;
  }
}
