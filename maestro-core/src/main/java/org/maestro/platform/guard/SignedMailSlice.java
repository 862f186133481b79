package org.maestro.platform.guard;

import jade.core.IMTPException;
import jade.core.Service;
import jade.core.ServiceException;

/** The request of the service to its part in another container. */
interface SignedMailSlice extends Service.Slice {
  String CERTIFICATE = "certificate";

  /** The encoded certificate by which that container's messages are signed. */
  byte[] certificate() throws IMTPException, ServiceException;
}
