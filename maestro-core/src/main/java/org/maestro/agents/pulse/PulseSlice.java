package org.maestro.agents.pulse;

import jade.core.IMTPException;
import jade.core.Service;

/** What the service of one container asks of that of the main container. */
public interface PulseSlice extends Service.Slice {

  /** The only thing that is asked. */
  String BEAT = "beat";

  /**
   * A sign of life.
   *
   * @param container its name
   * @param life tells it apart from other containers that have had or will have the name
   * @param report in the words of {@link Report}
   * @return as {@link Confirmation} writes it
   */
  String beat(String container, String life, String report) throws IMTPException;
}
