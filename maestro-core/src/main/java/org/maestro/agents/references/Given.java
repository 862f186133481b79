package org.maestro.agents.references;

import jade.core.AID;
import java.time.Duration;
import org.maestro.agents.pulse.Condition;
import org.maestro.agents.pulse.HeartbeatSettings;
import org.maestro.agents.pulse.Sealed;
import org.maestro.agents.pulse.SessionKey;

/** A reference to this agent that another has, as this one sees it. Agent thread only. */
final class Given {
  private final AID holder;
  private final SessionKey key = SessionKey.fresh();
  private final Silence silence;
  private long heard;

  Given(AID holder, HeartbeatSettings timing, Duration now) {
    this.holder = holder;
    this.silence = new Silence(timing, now);
  }

  AID holder() {
    return holder;
  }

  /** For the holder, and for nobody else. */
  SessionKey key() {
    return key;
  }

  Condition look(Duration now) {
    return silence.look(now);
  }

  /**
   * The confirmation of a sign of life, under the key that it brings.
   *
   * @throws IllegalArgumentException when the holder has not made it, or it was heard before
   */
  Sealed confirm(Sealed beat, Duration now) {
    if (!key.fits(SessionKey.Kind.BEAT, beat)) {
      throw new IllegalArgumentException("it is not sealed with the key of the reference");
    }
    if (beat.number() <= heard) {
      throw new IllegalArgumentException("it was heard before");
    }
    heard = beat.number();
    silence.broken(now);
    return SessionKey.read(beat.text()).seal(SessionKey.Kind.CONFIRMATION, heard, "");
  }
}
