package org.maestro.agents.device;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.maestro.rats.time.Clock;

/**
 * The first moments of an agent where it has just begun or moved to: its members make themselves
 * known a little later than others ask for them. What needs them waits, for a while. For the
 * agent's own thread.
 */
public final class Settling {
  /** Wall time; a member that has not been heard of by then is not there. */
  public static final Duration LONGEST = Duration.ofSeconds(3);

  private static final Duration LOOK_AGAIN = Duration.ofMillis(50);

  private final Clock clock;
  private final Duration until;
  private final BooleanSupplier ready;
  private final Consumer<Runnable> tell;

  /**
   * @param longest simulated time
   * @param ready whether all members have been heard of
   * @param tell has the agent do something on its own thread
   */
  public Settling(Clock clock, Duration longest, BooleanSupplier ready, Consumer<Runnable> tell) {
    this.clock = clock;
    this.until = clock.now().plus(longest);
    this.ready = ready;
    this.tell = tell;
  }

  public boolean isOver() {
    return clock.now().compareTo(until) >= 0 || ready.getAsBoolean();
  }

  /** Does it now or as soon as it makes sense. */
  public void once(Runnable deed) {
    if (isOver()) {
      deed.run();
    } else {
      Duration pause = clock.ofWall(LOOK_AGAIN);
      clock.schedule(pause, "settling", () -> tell.accept(() -> once(deed)));
    }
  }
}
