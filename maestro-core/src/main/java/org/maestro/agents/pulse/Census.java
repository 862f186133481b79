package org.maestro.agents.pulse;

import java.time.Duration;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;

/**
 * A watchdog over the agents of one container: each is given something to do now and then, and has
 * to have done it. Any thread may call.
 */
final class Census {
  /** Ten thousand agents are not woken all at once. */
  private static final int MOST_ASKED = 250;

  private final SortedMap<String, Asked> agents = new ConcurrentSkipListMap<>();
  private String last = "";

  private static final class Asked {
    private final Consumer<Runnable> tell;
    private final Runnable forsake;
    private final AtomicLong unansweredSinceMillis = new AtomicLong(-1);

    private Asked(Consumer<Runnable> tell, Runnable forsake) {
      this.tell = tell;
      this.forsake = forsake;
    }
  }

  void enlist(String name, Consumer<Runnable> tell, Runnable forsake) {
    agents.put(name, new Asked(tell, forsake));
  }

  /** Another takes the agent's place. */
  void forsake(String name) {
    Asked hung = agents.remove(name);
    if (hung != null) {
      hung.forsake.run();
    }
  }

  void leave(String name) {
    agents.remove(name);
  }

  /** Asks those whose turn it is. */
  synchronized void ask(Duration now) {
    int asked = 0;
    for (Map.Entry<String, Asked> agent : agents.tailMap(last + '\0').entrySet()) {
      if (++asked > MOST_ASKED) {
        return;
      }
      last = agent.getKey();
      ask(agent.getValue(), now);
    }
    last = "";
  }

  private static void ask(Asked agent, Duration now) {
    if (agent.unansweredSinceMillis.compareAndSet(-1, now.toMillis())) {
      agent.tell.accept(() -> agent.unansweredSinceMillis.set(-1));
    }
  }

  /** So long nobody could have answered. */
  void excuse(Duration lateness) {
    agents
        .values()
        .forEach(
            agent ->
                agent.unansweredSinceMillis.updateAndGet(
                    since -> since < 0 ? since : since + lateness.toMillis()));
  }

  /** Those who have been silent for the period or longer, and for how long. */
  SortedMap<String, Duration> silent(Duration now, Duration period) {
    SortedMap<String, Duration> silent = new TreeMap<>();
    agents.forEach(
        (name, agent) -> {
          Duration silence = silence(agent, now);
          if (silence.compareTo(period) >= 0) {
            silent.put(name, silence);
          }
        });
    return silent;
  }

  private static Duration silence(Asked agent, Duration now) {
    long since = agent.unansweredSinceMillis.get();
    return since < 0 ? Duration.ZERO : now.minusMillis(since);
  }
}
