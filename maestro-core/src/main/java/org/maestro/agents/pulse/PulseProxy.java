package org.maestro.agents.pulse;

import jade.core.GenericCommand;
import jade.core.IMTPException;
import jade.core.ServiceException;
import jade.core.SliceProxy;

/** Carries signs of life to another process. JADE makes it by its name. */
public final class PulseProxy extends SliceProxy implements PulseSlice {
  private static final long serialVersionUID = 1L;

  @Override
  public void end(String agent) throws IMTPException {
    GenericCommand command = new GenericCommand(END, PulseService.NAME, null);
    command.addParam(agent);
    try {
      if (getNode().accept(command) instanceof Throwable problem) {
        throw new IMTPException("The agent " + agent + " is not taken out", problem);
      }
    } catch (ServiceException e) {
      throw new IMTPException("The container has no heartbeats", e);
    }
  }

  @Override
  public String beat(String beat) throws IMTPException {
    GenericCommand command = new GenericCommand(BEAT, PulseService.NAME, null);
    command.addParam(beat);
    try {
      Object answer = getNode().accept(command);
      if (answer instanceof String text) {
        return text;
      }
      throw new IMTPException(
          "A sign of life was answered with " + answer,
          answer instanceof Throwable cause ? cause : null);
    } catch (ServiceException e) {
      throw new IMTPException("The main container has no heartbeats", e);
    }
  }
}
