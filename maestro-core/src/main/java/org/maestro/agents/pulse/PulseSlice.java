package org.maestro.agents.pulse;

import jade.core.IMTPException;
import jade.core.Service;

/** The requests of the pulse services of containers to each other. */
public interface PulseSlice extends Service.Slice {

  String BEAT = "beat";
  String END = "end";
  String BEGIN = "begin";
  String KEY = "key";
  String SESSION = "session";

  /**
   * A sign of life.
   *
   * @param beat in the words of {@link Beat}, sealed
   * @return as {@link Confirmation} writes it, sealed
   */
  String beat(String beat) throws IMTPException;

  /**
   * Takes an agent that hangs out of the container.
   *
   * @param order its name, sealed by the main container
   */
  void end(String order) throws IMTPException;

  /**
   * Asks the main container for a session.
   *
   * @param container that asks, which is told the key
   * @param request comes with the key
   */
  void begin(String container, String request) throws IMTPException;

  /** The key that the container has asked for with this request. */
  void key(String request, String key) throws IMTPException;

  /** The name of the session of the container's process; empty when it has none. */
  String session() throws IMTPException;
}
