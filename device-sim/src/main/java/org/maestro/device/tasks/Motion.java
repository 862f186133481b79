package org.maestro.device.tasks;

import java.time.Duration;
import java.util.Collection;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.rats.time.Clock;

/**
 * What a robot's base is at, so that it can be ended from beside: whoever is told to stand still
 * knows nothing of the feature that has it drive; and what stood in its way a moment ago. Shared by
 * the features of a device. Clock thread only.
 */
public final class Motion {
  /** Who was asked to step aside has done so by then, or will not. */
  private static final Duration TOLD = Duration.ofSeconds(20);

  private final Clock clock;
  private final String device;
  private Optional<Runnable> halting = Optional.empty();
  private Set<String> bars = Set.of();
  private Clock.Timer forgetting = () -> {};
  private Runnable changed = () -> {};

  public Motion(Clock clock, String device) {
    this.clock = clock;
    this.device = device;
  }

  /** What is to be done whenever something else stands in the way. */
  public void whenBarsChange(Runnable action) {
    changed = action;
  }

  /** Names of what stands in the way, as was found at most twenty seconds ago. */
  public Set<String> bars() {
    return bars;
  }

  /** There is no free way, as these stand in it: beside those in the way to somewhere else. */
  void barredBy(Collection<String> names) {
    if (!names.isEmpty()) {
      forgetting.cancel();
      forgetting = clock.schedule(TOLD, device, () -> bars(Set.of()));
      Set<String> all = new TreeSet<>(bars);
      all.addAll(names);
      bars(Set.copyOf(all));
    }
  }

  /** There is a free way. */
  void free() {
    forgetting.cancel();
    bars(Set.of());
  }

  private void bars(Set<String> names) {
    boolean same = names.equals(bars);
    bars = names;
    if (!same) {
      changed.run();
    }
  }

  /**
   * It has begun.
   *
   * @param halted to be run once, if it is ended before it is over
   */
  void begin(Runnable halted) {
    halting = Optional.of(halted);
  }

  /** It is over by itself, or was cancelled. */
  void over() {
    halting = Optional.empty();
  }

  /** Ends what is under way, if anything is. */
  void halt() {
    Optional<Runnable> halted = halting;
    halting = Optional.empty();
    halted.ifPresent(Runnable::run);
  }
}
