package org.maestro.platform.guard;

import jade.core.AID;
import jade.core.AgentContainer;
import jade.core.ContainerID;
import jade.core.IMTPException;
import jade.core.NotFoundException;
import jade.core.Service;
import jade.core.ServiceException;
import jade.core.ServiceFinder;
import jade.core.messaging.MessagingSlice;
import java.security.GeneralSecurityException;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * By which certificate an agent's messages have to be signed: that of the process it lives in, as
 * the platform's own tables and then that process say. What was found out is remembered for a
 * while. Thread-safe.
 */
final class Holders {
  private static final Duration REMEMBERED = Duration.ofSeconds(60);
  private static final int MOST = 20_000;

  private final AgentContainer container;
  private final X509Certificate own;
  private final Slices slices;
  private final Map<String, Known> knownByAgent =
      new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Known> eldest) {
          return size() > MOST;
        }
      };

  private record Known(X509Certificate certificate, long sinceNanos) {
    boolean isFresh() {
      return System.nanoTime() - sinceNanos < REMEMBERED.toNanos();
    }
  }

  /** The service's parts in other containers, by their names. */
  interface Slices {
    Service.Slice of(String container) throws ServiceException;
  }

  Holders(AgentContainer container, X509Certificate own, Slices slices) {
    this.container = container;
    this.own = own;
    this.slices = slices;
  }

  /** Whether the agent lives where messages are signed by that certificate. */
  boolean isHeldBy(AID agent, X509Certificate certificate) {
    if (container.isLocalAgent(agent)) {
      return own.equals(certificate);
    }
    Optional<Known> known = known(agent);
    if (known.filter(k -> k.isFresh() && k.certificate().equals(certificate)).isPresent()) {
      return true;
    }
    Optional<X509Certificate> found = found(agent);
    // Who has ended since it sent the message is found no more.
    return found.or(() -> known.map(Known::certificate)).filter(certificate::equals).isPresent();
  }

  private synchronized Optional<Known> known(AID agent) {
    return Optional.ofNullable(knownByAgent.get(agent.getName()));
  }

  private Optional<X509Certificate> found(AID agent) {
    try {
      MessagingSlice main =
          (MessagingSlice)
              container.getServiceFinder().findSlice(MessagingSlice.NAME, ServiceFinder.MAIN_SLICE);
      ContainerID place = main.getAgentLocation(agent);
      SignedMailSlice there = (SignedMailSlice) slices.of(place.getName());
      X509Certificate certificate = Seal.certificate(there.certificate());
      synchronized (this) {
        knownByAgent.put(agent.getName(), new Known(certificate, System.nanoTime()));
      }
      return Optional.of(certificate);
    } catch (NotFoundException
        | IMTPException
        | ServiceException
        | GeneralSecurityException nowhere) {
      return Optional.empty();
    }
  }
}
