package org.maestro.platform.guard;

import jade.core.GenericCommand;
import jade.core.IMTPException;
import jade.core.ServiceException;
import jade.core.SliceProxy;

/** Asks the service in another container; JADE makes it by the service's name and "Proxy". */
public final class SignedMailProxy extends SliceProxy implements SignedMailSlice {
  private static final long serialVersionUID = 1L;

  @Override
  public byte[] certificate() throws IMTPException, ServiceException {
    Object answer = getNode().accept(new GenericCommand(CERTIFICATE, SignedMailService.NAME, null));
    if (answer instanceof byte[] encoded) {
      return encoded;
    }
    throw new ServiceException("A container tells no certificate: " + answer);
  }
}
