package org.maestro.platform.guard;

import static java.nio.charset.StandardCharsets.ISO_8859_1;

import jade.core.Agent;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.ObjectStreamClass;
import java.util.Collection;
import java.util.Map;
import java.util.stream.Stream;
import org.maestro.agents.GenericAgent;

/**
 * An agent that arrives as bytes. Only classes of this process are looked for, and only those that
 * a generic agent is made of are let in; the time and the memory that it takes are bounded.
 */
final class Arrival extends ObjectInputStream {
  /**
   * As many places JADE's agent makes for objects of other programs while it is read, which may be
   * more than there is memory. Generic agents take none.
   */
  private static final String PLACES = "o2aQueueSize";

  /** A name that no field has, so that what is stated under it is passed over. */
  private static final String PASSED_OVER = "O2aQueueSize";

  private Arrival(byte[] bytes) throws IOException {
    super(new ByteArrayInputStream(withoutPlaces(bytes)));
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

  private static byte[] withoutPlaces(byte[] bytes) {
    return new String(bytes, ISO_8859_1)
        .replace(asField(PLACES), asField(PASSED_OVER))
        .getBytes(ISO_8859_1);
  }

  /** As a class's description in a stream has it: after its length in two bytes. */
  private static String asField(String name) {
    return "I\0" + (char) name.length() + name;
  }

  /** The same name may be spelt in other bytes. */
  @Override
  protected Class<?> resolveClass(ObjectStreamClass described)
      throws IOException, ClassNotFoundException {
    if (Stream.of(described.getFields()).anyMatch(field -> field.getName().equals(PLACES))) {
      throw new InvalidObjectException("it asks for places for objects of other programs");
    }
    return super.resolveClass(described);
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
