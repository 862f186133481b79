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
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.maestro.rats.bounded.BoundedMap;
import org.maestro.rats.security.ContainerAccess;

/**
 * By whose certificate an agent's messages have to be signed: that of the user whose process it
 * lives in, as the platform's own tables and then that process say. What was found out is
 * remembered for a while. Thread-safe.
 */
final class Holders {
  private static final Duration REMEMBERED = Duration.ofSeconds(60);
  private static final int MOST = 20_000;

  private final AgentContainer container;
  private final Supplier<ContainerAccess> access;
  private final Slices slices;
  private final Map<String, Known> knownByAgent = BoundedMap.ofNewest(MOST);

  private record Known(String user, long sinceNanos) {
    boolean isFresh() {
      return System.nanoTime() - sinceNanos < REMEMBERED.toNanos();
    }
  }

  /** The service's parts in other containers, by their names. */
  interface Slices {
    Service.Slice of(String container) throws ServiceException;
  }

  /**
   * @param access of this process, as it is now
   */
  Holders(AgentContainer container, Supplier<ContainerAccess> access, Slices slices) {
    this.container = container;
    this.access = access;
    this.slices = slices;
  }

  /**
   * Whether the agent lives in a process of that user, who may have had another certificate when it
   * spoke.
   */
  boolean isHeldBy(AID agent, String user) {
    if (container.isLocalAgent(agent)) {
      return access.get().user().equals(user);
    }
    Optional<Known> known = known(agent);
    if (known.filter(k -> k.isFresh() && k.user().equals(user)).isPresent()) {
      return true;
    }
    Optional<String> found = found(agent);
    // Who has ended since it sent the message is found no more.
    return found.or(() -> known.map(Known::user)).filter(user::equals).isPresent();
  }

  private synchronized Optional<Known> known(AID agent) {
    return Optional.ofNullable(knownByAgent.get(agent.getName()));
  }

  private Optional<String> found(AID agent) {
    try {
      MessagingSlice main =
          (MessagingSlice)
              container.getServiceFinder().findSlice(MessagingSlice.NAME, ServiceFinder.MAIN_SLICE);
      ContainerID place = main.getAgentLocation(agent);
      SignedMailSlice there = (SignedMailSlice) slices.of(place.getName());
      Optional<String> user = access.get().holder(Seal.certificate(there.certificate()));
      synchronized (this) {
        user.ifPresent(its -> knownByAgent.put(agent.getName(), new Known(its, System.nanoTime())));
      }
      return user;
    } catch (NotFoundException
        | IMTPException
        | ServiceException
        | GeneralSecurityException nowhere) {
      return Optional.empty();
    }
  }
}
