package org.maestro.agents.pulse;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.rats.bounded.BoundedMap;
import org.maestro.rats.time.Clock;

/** The watch of a main container over all containers. Any thread may call. */
final class ContainerWatch {
  private static final int REMEMBERED = 10_000;

  /** Where more agents of a process are silent at once, they wait for time, and none hangs. */
  private static final int MOST_HANG = 8;

  private final Clock clock;
  private final HeartbeatSettings settings;
  private final Watcher watcher;
  private final Heartbeats containers;
  private final Map<String, String> lifeByContainer = new TreeMap<>();
  private final Map<String, Duration> silenceByAgent = new TreeMap<>();
  private final SortedMap<String, Condition> conditionByAgent = new TreeMap<>();
  private final Map<String, List<String>> addressesByContainer = new TreeMap<>();
  private final Map<String, Beat> beatByContainer = new TreeMap<>();
  private final Map<String, String> givenUp = BoundedMap.ofNewest(REMEMBERED);
  private volatile boolean ended;

  /**
   * @param own the container that watches
   */
  ContainerWatch(Clock clock, HeartbeatSettings settings, String own, Watcher watcher) {
    this.clock = clock;
    this.settings = settings;
    this.watcher = watcher;
    this.containers = new Heartbeats(settings, own, now());
  }

  void begin() {
    tick();
  }

  void end() {
    ended = true;
  }

  private Duration now() {
    return clock.toWall(clock.now());
  }

  private void tick() {
    clock.schedule(
        clock.ofWall(settings.period()),
        "watch",
        () -> {
          if (!ended) {
            check();
            tick();
          }
        });
  }

  /**
   * A process gives a sign of life.
   *
   * @param joined names of the containers of this platform
   */
  synchronized Confirmation heard(Beat beat, Set<String> joined) {
    Set<String> unwelcome = new TreeSet<>();
    for (Beat.Living container : beat.containers()) {
      if (!joined.contains(container.name()) || !isWelcome(container)) {
        unwelcome.add(container.life());
      } else {
        beatByContainer.put(container.name(), beat);
        addressesByContainer.put(container.name(), container.addresses());
      }
    }
    return new Confirmation(
        settings.period(), containers.lostAfter().minus(settings.period()), unwelcome);
  }

  private boolean isWelcome(Beat.Living living) {
    String container = living.name();
    String life = living.life();
    if (givenUp.containsKey(life)) {
      return false;
    }
    String before = lifeByContainer.get(container);
    if (before != null
        && !before.equals(life)
        && containers.conditions().get(container) == Condition.ALIVE) {
      // JADE gives a name once; whoever else uses it joined a platform that is no more.
      givenUp.put(life, container);
      return false;
    }
    lifeByContainer.put(container, life);
    if (!life.equals(before)) {
      containers.forget(container);
      if (before != null) {
        givenUp.put(before, container);
      }
    }
    containers.heard(container, now());
    return true;
  }

  /** JADE says that the container is no more; it may have ended as it should. */
  synchronized void ended(String container) {
    String life = lifeByContainer.remove(container);
    if (life != null) {
      givenUp.put(life, container);
    }
    containers.forget(container);
    beatByContainer.remove(container);
    addressesByContainer.remove(container);
  }

  private void check() {
    List<Heartbeats.Change> changed = checkContainers();
    changed.forEach(change -> watcher.container(change.name(), change.now(), change.silence()));
    checkAgents();
  }

  private synchronized List<Heartbeats.Change> checkContainers() {
    List<Heartbeats.Change> changed = containers.check(now());
    for (Heartbeats.Change change : changed) {
      if (change.now() == Condition.LOST) {
        String life = lifeByContainer.remove(change.name());
        if (life != null) {
          givenUp.put(life, change.name());
        }
      }
    }
    return changed;
  }

  private void checkAgents() {
    Map<String, Condition> changed = new TreeMap<>();
    synchronized (this) {
      silenceByAgent.clear();
      beatByContainer.forEach(
          (container, beat) -> {
            if (lifeByContainer.containsKey(container)) {
              judge(beat, containers.lateness(container));
            }
          });
      for (Map.Entry<String, Duration> entry : silenceByAgent.entrySet()) {
        note(entry.getKey(), condition(entry.getValue()), changed);
      }
      conditionByAgent.keySet().stream()
          .filter(agent -> !silenceByAgent.containsKey(agent))
          .toList()
          .forEach(agent -> note(agent, Condition.ALIVE, changed));
    }
    changed.forEach(
        (agent, now) ->
            watcher.agent(agent, now, silenceByAgent.getOrDefault(agent, Duration.ZERO)));
  }

  /** A process that gets no time gives none to its agents. */
  private void judge(Beat beat, Duration late) {
    Map<String, Duration> silences = new TreeMap<>();
    beat.silences().forEach((agent, silence) -> silences.put(agent, silence.minus(late)));
    long silent = silences.values().stream().filter(this::isSuspicious).count();
    Duration longest = containers.hungAfter().minus(settings.period());
    silences.forEach(
        (agent, silence) ->
            silenceByAgent.put(
                agent, silent > MOST_HANG && silence.compareTo(longest) > 0 ? longest : silence));
  }

  private boolean isSuspicious(Duration silence) {
    return silence.compareTo(containers.suspectedAfter()) >= 0;
  }

  private void note(String agent, Condition now, Map<String, Condition> changed) {
    if (conditionByAgent.getOrDefault(agent, Condition.ALIVE) != now) {
      changed.put(agent, now);
    }
    if (now == Condition.ALIVE) {
      conditionByAgent.remove(agent);
    } else {
      conditionByAgent.put(agent, now);
    }
  }

  private Condition condition(Duration silence) {
    if (silence.compareTo(containers.hungAfter()) >= 0) {
      return Condition.LOST;
    }
    return isSuspicious(silence) ? Condition.SUSPECTED : Condition.ALIVE;
  }

  /** Where the container's process was reached, as it said itself. */
  synchronized List<String> addresses(String container) {
    return addressesByContainer.getOrDefault(container, List.of());
  }

  synchronized Signs signs() {
    return new Signs(containers.timing(), containers.signs(now()), conditionByAgent);
  }
}
