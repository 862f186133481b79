package org.maestro.sim.drivers;

import java.util.Optional;
import org.maestro.hal.Position;
import org.maestro.hal.Target;

/** The way in which a simulated camera finds things in what it has in view. Clock thread only. */
public interface Detection {

  /** What so many frames show of the wanted thing, as it is now. */
  Seen of(Target target, int frames);

  /**
   * @param detections frames that agree
   * @param place where it is believed to be; empty when none shows it
   * @param doubt why nothing can be said; one sentence
   */
  record Seen(int detections, Optional<Position> place, Optional<String> doubt) {

    static Seen doubtful(String reason) {
      return new Seen(0, Optional.empty(), Optional.of(reason));
    }
  }
}
