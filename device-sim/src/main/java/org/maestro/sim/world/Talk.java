package org.maestro.sim.world;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.maestro.rats.time.Clock;

/**
 * What is said in the world, by persons and by loudspeakers. Any thread may call it; who listens is
 * told on the clock's.
 */
public final class Talk {
  private static final int MOST_KEPT = 200;

  private final World world;
  private final Clock clock;
  private final List<Listener> listeners = new CopyOnWriteArrayList<>();
  private final List<Sounded> sounded = new ArrayList<>();

  Talk(World world, Clock clock) {
    this.world = world;
    this.clock = clock;
  }

  /** Told on the clock's thread. */
  public interface Listener {
    /**
     * Somebody begins to say something.
     *
     * @param zone in which the person is; empty when nowhere
     */
    void begins(String person, Optional<String> zone, List<String> words);
  }

  /**
   * What a loudspeaker has said.
   *
   * @param at since the start, when it was heard to its end
   * @param zone in which it was heard
   */
  public record Sounded(Duration at, String device, String zone, String text) {}

  /** Is told of all that is said from now on. */
  public void listen(Listener listener) {
    listeners.add(listener);
  }

  /** A person says something, where she is. */
  public void say(String person, String text) {
    List<String> words = List.of(text.strip().split("\\s+"));
    clock.schedule(
        Duration.ZERO,
        person,
        () -> {
          Optional<String> zone = world.zone(person);
          listeners.forEach(listener -> listener.begins(person, zone, words));
        });
  }

  /** A loudspeaker was heard. */
  public void sounds(String device, String zone, String text) {
    synchronized (world) {
      sounded.add(new Sounded(clock.now(), device, zone, text));
      if (sounded.size() > MOST_KEPT) {
        sounded.remove(0);
      }
    }
  }

  /** What loudspeakers have said, the first first; the last two hundred. */
  public List<Sounded> sounded() {
    synchronized (world) {
      return List.copyOf(sounded);
    }
  }
}
