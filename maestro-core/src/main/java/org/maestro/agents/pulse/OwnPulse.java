package org.maestro.agents.pulse;

import jade.core.IMTPException;
import jade.core.ServiceException;
import java.time.Duration;
import java.util.Optional;
import java.util.SortedMap;
import java.util.UUID;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The signs of life of one container, given on a thread of their own, as the network may hold them
 * up. Any thread may call.
 */
final class OwnPulse {
  private static final Logger LOG = LoggerFactory.getLogger(OwnPulse.class);

  /** Nobody answers any more: the platform has ended, or another main container has taken over. */
  private static final int LEASES_UNTIL_ORPHANED = 2;

  /** How a sign of life gets to the main container. */
  interface Road {
    String beat(String life, SortedMap<String, Duration> silent)
        throws IMTPException, ServiceException;
  }

  private final String life = UUID.randomUUID().toString();
  private final Census census = new Census();
  private final Road road;
  private final AtomicBoolean onItsWay = new AtomicBoolean();
  private final AtomicBoolean givenUp = new AtomicBoolean();
  private final ExecutorService sender =
      Executors.newSingleThreadExecutor(
          beat -> {
            Thread thread = new Thread(beat, "maestro-pulse");
            thread.setDaemon(true);
            return thread;
          });
  private volatile Optional<Clock> clock = Optional.empty();
  private volatile HeartbeatSettings settings = HeartbeatSettings.standard();
  private volatile Duration lease = settings.lease();
  private volatile Duration confirmed = Duration.ZERO;
  private volatile Optional<Runnable> listener = Optional.empty();
  private volatile boolean refused;
  private volatile boolean ended;

  OwnPulse(Road road) {
    this.road = road;
  }

  void enlist(String name, Consumer<Runnable> tell, Runnable forsake, Clock its) {
    census.enlist(name, tell, forsake);
    begin(its);
  }

  void forsake(String name) {
    census.forsake(name);
  }

  void leave(String name) {
    census.leave(name);
  }

  private synchronized void begin(Clock its) {
    if (clock.isEmpty() && !ended) {
      clock = Optional.of(its);
      confirmed = now();
      tick(Duration.ZERO);
    }
  }

  void end() {
    ended = true;
    sender.shutdownNow();
  }

  void whenGivenUp(Runnable told) {
    listener = Optional.of(told);
    if (givenUp.get()) {
      told.run();
    }
  }

  boolean isCutOff() {
    return givenUp.get() || silence().compareTo(lease) > 0;
  }

  /** Whether no sign of life is on its way. */
  boolean isQuiet() {
    return !onItsWay.get();
  }

  private Duration silence() {
    return clock.isEmpty() ? Duration.ZERO : now().minus(confirmed);
  }

  /** Wall time. */
  private Duration now() {
    Clock its = clock.orElseThrow();
    return Duration.ofNanos(Math.round(its.now().toNanos() / its.speed()));
  }

  private void tick(Duration delay) {
    Clock its = clock.orElseThrow();
    its.schedule(
        Duration.ofNanos(Math.round(delay.toNanos() * its.speed())), "pulse", this::beatOnce);
  }

  private void beatOnce() {
    if (ended || givenUp.get()) {
      return;
    }
    census.ask(now());
    if (silence().compareTo(refused ? lease : lease.multipliedBy(LEASES_UNTIL_ORPHANED)) > 0) {
      giveUp("The platform has not been heard of for " + silence().toSeconds() + " s");
      return;
    }
    if (onItsWay.compareAndSet(false, true)) {
      try {
        sender.execute(this::send);
      } catch (RejectedExecutionException e) {
        LOG.debug("The container ends: no sign of life is given any more");
        return;
      }
    }
    tick(settings.period());
  }

  private void send() {
    Duration sent = now();
    try {
      Confirmation answer =
          Confirmation.read(road.beat(life, census.silent(sent, settings.period())));
      lease = answer.lease();
      refused = false;
      if (answer.welcome()) {
        confirmed = sent;
      } else {
        giveUp("The platform has given this container up");
      }
    } catch (IMTPException | ServiceException | IllegalArgumentException e) {
      refused = true;
      LOG.debug("A sign of life did not get through", e);
    } finally {
      onItsWay.set(false);
    }
  }

  private void giveUp(String why) {
    if (!ended && givenUp.compareAndSet(false, true)) {
      LOG.warn("{}; its agents begin nothing any more.", why);
      listener.ifPresent(Runnable::run);
    }
  }
}
