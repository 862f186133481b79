package org.maestro.agents.references;

import java.time.Duration;
import org.maestro.agents.pulse.Condition;
import org.maestro.agents.pulse.HeartbeatSettings;

/** The silence of one who should give signs of life. Times are wall time since some start. */
final class Silence {
  private final HeartbeatSettings timing;
  private Duration heard;
  private Duration looked;

  Silence(HeartbeatSettings timing, Duration now) {
    this.timing = timing;
    this.heard = now;
    this.looked = now;
  }

  void broken(Duration now) {
    heard = now;
  }

  /**
   * What its silence means now. To be asked each period: who has slept itself has heard nobody
   * meanwhile, and cannot say that he was silent.
   */
  Condition look(Duration now) {
    Duration late = now.minus(looked).minus(timing.period());
    looked = now;
    if (late.compareTo(timing.period()) > 0) {
      heard = heard.plus(late);
    }
    Duration silence = now.minus(heard);
    if (silence.compareTo(timing.lostAfter()) >= 0) {
      return Condition.LOST;
    }
    return silence.compareTo(timing.suspectedAfter()) >= 0 ? Condition.SUSPECTED : Condition.ALIVE;
  }
}
