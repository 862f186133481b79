package org.maestro.agents.pulse;

import jade.core.IMTPException;
import jade.core.ServiceException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The signs of life of all containers that one platform has in this process: they live and freeze
 * together, so that one sign is enough for all. They are given on a thread of their own, as the
 * network may hold them up. Any thread may call.
 */
public final class ProcessPulse {
  /** Where a container's profile holds the one that it shares with others. */
  public static final String KEY = "maestro-pulse";

  private static final Logger LOG = LoggerFactory.getLogger(ProcessPulse.class);

  /** Nobody answers any more: the platform has ended, or another main container has taken over. */
  private static final int LEASES_UNTIL_ORPHANED = 2;

  private final ProcessSession session = new ProcessSession();
  private final List<OwnPulse> containers = new CopyOnWriteArrayList<>();
  private final AtomicBoolean onItsWay = new AtomicBoolean();
  private volatile Optional<Beating> beating = Optional.empty();
  private volatile HeartbeatSettings settings = HeartbeatSettings.standard();
  private volatile Duration lease = settings.lease();
  private volatile Duration confirmed = Duration.ZERO;
  private volatile Duration lastAsked = Duration.ZERO;
  private volatile Duration unanswered = Duration.ZERO;
  private volatile boolean refused;

  /** From the first container to the end of the last. */
  private record Beating(Clock clock, ExecutorService sender) {
    /** Wall time. */
    Duration now() {
      return clock.toWall(clock.now());
    }
  }

  /** The session of the process with the main container. */
  ProcessSession session() {
    return session;
  }

  /** From now on the signs of life speak of this container too. */
  synchronized void begin(OwnPulse container, Clock clock) {
    if (containers.contains(container)) {
      return;
    }
    containers.add(container);
    if (beating.isEmpty()) {
      Beating begun = new Beating(clock, Executors.newSingleThreadExecutor(ProcessPulse::thread));
      beating = Optional.of(begun);
      confirmed = begun.now();
      lastAsked = begun.now();
      unanswered = Duration.ZERO;
      tick(begun, Duration.ZERO);
    }
  }

  private static Thread thread(Runnable beats) {
    Thread thread = new Thread(beats, "maestro-pulse");
    thread.setDaemon(true);
    return thread;
  }

  synchronized void leave(OwnPulse container) {
    containers.remove(container);
    if (containers.isEmpty()) {
      beating.ifPresent(ending -> ending.sender().shutdownNow());
      beating = Optional.empty();
    }
  }

  /** Whether another may act in the place of these containers by now. */
  boolean isOverdue() {
    return !isOfMain()
        && beating.filter(now -> now.now().minus(confirmed).compareTo(lease) > 0).isPresent();
  }

  /** Whether no sign of life is on its way. */
  boolean isQuiet() {
    return !onItsWay.get();
  }

  /** Nobody but who judges can act in the place of its own containers. */
  private boolean isOfMain() {
    return containers.stream().anyMatch(OwnPulse::isMain);
  }

  private void tick(Beating its, Duration delay) {
    Clock clock = its.clock();
    clock.schedule(clock.ofWall(delay), "pulse", () -> beat(its));
  }

  private void beat(Beating its) {
    if (beating.filter(its::equals).isEmpty()) {
      return;
    }
    askAll(its.now());
    Duration longest = refused ? lease : lease.multipliedBy(LEASES_UNTIL_ORPHANED);
    if (unanswered.compareTo(longest) > 0 && !isOfMain()) {
      String why =
          "The platform has not been heard of for " + its.now().minus(confirmed).toSeconds() + " s";
      containers.forEach(container -> container.giveUp(why));
      return;
    }
    if (onItsWay.compareAndSet(false, true)) {
      try {
        its.sender().execute(() -> send(its));
      } catch (RejectedExecutionException e) {
        onItsWay.set(false);
        LOG.debug("The last container ends: no sign of life is given any more");
        return;
      }
    }
    tick(its, settings.period());
  }

  /**
   * A process that has slept itself does not take its agents for those that hang, and has not
   * listened to the platform meanwhile.
   */
  private void askAll(Duration now) {
    Duration since = now.minus(lastAsked);
    Duration late = since.minus(settings.period());
    boolean hasSlept = late.compareTo(settings.period()) > 0;
    lastAsked = now;
    unanswered = unanswered.plus(hasSlept ? settings.period() : since);
    if (hasSlept) {
      containers.forEach(container -> container.excuse(late));
    }
    containers.forEach(container -> container.ask(now));
  }

  private void send(Beating its) {
    Duration sent = its.now();
    try {
      Optional<OwnPulse> messenger =
          containers.stream()
              .filter(OwnPulse::isMain)
              .findFirst()
              .or(() -> containers.stream().findFirst());
      if (messenger.isPresent()) {
        answered(sent, Confirmation.read(messenger.get().beat(beatAt(sent).write())));
      }
    } catch (IMTPException | ServiceException | IllegalArgumentException e) {
      refused = true;
      LOG.debug("A sign of life did not get through", e);
    } finally {
      onItsWay.set(false);
    }
  }

  private Beat beatAt(Duration now) {
    SortedMap<String, Duration> silences = new TreeMap<>();
    containers.forEach(container -> silences.putAll(container.silent(now, settings.period())));
    return new Beat(containers.stream().map(OwnPulse::living).toList(), silences);
  }

  private void answered(Duration sent, Confirmation answer) {
    lease = answer.lease();
    refused = false;
    confirmed = sent;
    unanswered = Duration.ZERO;
    containers.stream()
        .filter(container -> answer.givenUp().contains(container.life()))
        .forEach(container -> container.giveUp("The platform has given this container up"));
  }
}
