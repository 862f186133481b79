package org.maestro.agents.pulse;

import jade.core.IMTPException;
import jade.core.Service;

/** The requests of the pulse services of containers to each other. */
public interface PulseSlice extends Service.Slice {

  String BEAT = "beat";
  String END = "end";

  /**
   * A sign of life.
   *
   * @param beat in the words of {@link Beat}
   * @return as {@link Confirmation} writes it
   */
  String beat(String beat) throws IMTPException;

  /** Takes an agent that hangs out of the container. */
  void end(String agent) throws IMTPException;
}
