package org.maestro.agents.pulse;

import jade.core.IMTPException;
import jade.core.ServiceException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The part of one container in the signs of life of its process. Any thread may call. */
final class OwnPulse {
  private static final Logger LOG = LoggerFactory.getLogger(OwnPulse.class);

  /** The way of a sign of life to the main container, and what it says of this one. */
  interface Road {
    String beat(String beat) throws IMTPException, ServiceException;

    String container();

    List<String> addresses();

    /** Whether it is the main container: then it is told of nobody but itself. */
    boolean isMain();
  }

  private final String life = UUID.randomUUID().toString();
  private final Census census = new Census();
  private final ProcessPulse process;
  private final Road road;
  private final AtomicBoolean givenUp = new AtomicBoolean();
  private volatile Optional<Runnable> listener = Optional.empty();
  private volatile boolean ended;

  OwnPulse(ProcessPulse process, Road road) {
    this.process = process;
    this.road = road;
  }

  void enlist(String name, Consumer<Runnable> tell, Runnable forsake, Clock clock) {
    census.enlist(name, tell, forsake);
    if (!ended && !givenUp.get()) {
      process.begin(this, clock);
    }
  }

  void forsake(String name) {
    census.forsake(name);
  }

  void leave(String name) {
    census.leave(name);
  }

  void end() {
    ended = true;
    process.leave(this);
  }

  void whenGivenUp(Runnable told) {
    listener = Optional.of(told);
    if (givenUp.get()) {
      told.run();
    }
  }

  boolean isCutOff() {
    return givenUp.get() || process.isOverdue();
  }

  /** Whether others act in the place of this container's agents, under their names. */
  boolean isGivenUp() {
    return givenUp.get();
  }

  void giveUp(String why) {
    process.leave(this);
    if (!ended && givenUp.compareAndSet(false, true)) {
      LOG.warn("{}; the agents in {} begin nothing any more.", why, road.container());
      listener.ifPresent(Runnable::run);
    }
  }

  String life() {
    return life;
  }

  Beat.Living living() {
    return new Beat.Living(road.container(), life, road.addresses());
  }

  void ask(Duration now) {
    census.ask(now);
  }

  void excuse(Duration lateness) {
    census.excuse(lateness);
  }

  SortedMap<String, Duration> silent(Duration now, Duration period) {
    return census.silent(now, period);
  }

  boolean isMain() {
    return road.isMain();
  }

  String beat(String beat) throws IMTPException, ServiceException {
    return road.beat(beat);
  }
}
