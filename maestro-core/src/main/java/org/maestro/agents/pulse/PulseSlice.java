package org.maestro.agents.pulse;

import jade.core.IMTPException;
import jade.core.Service;

/** What the services of containers ask of each other. */
public interface PulseSlice extends Service.Slice {

  String BEAT = "beat";
  String END = "end";

  /**
   * A sign of life.
   *
   * @param container its name
   * @param life tells it apart from other containers that have had or will have the name
   * @param report in the words of {@link Report}
   * @return as {@link Confirmation} writes it
   */
  String beat(String container, String life, String report) throws IMTPException;

  /** Takes an agent that hangs out of the container. */
  void end(String agent) throws IMTPException;
}
