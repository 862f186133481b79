package org.maestro.agents.pulse;

import jade.core.GenericCommand;
import jade.core.IMTPException;
import jade.core.ServiceException;
import jade.core.SliceProxy;
import org.jspecify.annotations.Nullable;

/** Carries signs of life to another process. JADE makes it by its name. */
public final class PulseProxy extends SliceProxy implements PulseSlice {
  private static final long serialVersionUID = 1L;

  @Override
  public void end(String order) throws IMTPException {
    asked(END, order);
  }

  @Override
  public void begin(String container, String request) throws IMTPException {
    asked(BEGIN, container, request);
  }

  @Override
  public void key(String request, String key) throws IMTPException {
    asked(KEY, request, key);
  }

  @Override
  public String beat(String beat) throws IMTPException {
    return text(asked(BEAT, beat));
  }

  @Override
  public String session() throws IMTPException {
    return text(asked(SESSION));
  }

  private static String text(@Nullable Object answer) throws IMTPException {
    if (answer instanceof String text) {
      return text;
    }
    throw new IMTPException("The heartbeats of a container answer with " + answer);
  }

  private @Nullable Object asked(String name, String... parameters) throws IMTPException {
    GenericCommand command = new GenericCommand(name, PulseService.NAME, null);
    for (String parameter : parameters) {
      command.addParam(parameter);
    }
    try {
      Object answer = getNode().accept(command);
      if (answer instanceof Throwable problem) {
        throw new IMTPException("A container refuses the heartbeats' " + name, problem);
      }
      return answer;
    } catch (ServiceException e) {
      throw new IMTPException("The container has no heartbeats", e);
    }
  }
}
