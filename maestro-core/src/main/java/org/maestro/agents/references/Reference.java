package org.maestro.agents.references;

import jade.core.AID;
import java.time.Duration;
import org.maestro.agents.pulse.Condition;
import org.maestro.agents.pulse.HeartbeatSettings;
import org.maestro.agents.pulse.Sealed;
import org.maestro.agents.pulse.SessionKey;

/**
 * A reference to another agent, as the one that has it sees it: by signs of life which the other
 * confirms. Agent thread only, but for what says otherwise.
 */
public final class Reference {
  private final AID agent;
  private final String conversation;
  private final Holder holder;
  private final SessionKey toAgent;
  private final SessionKey fromAgent = SessionKey.fresh();
  private final Silence silence;
  private volatile Condition condition = Condition.ALIVE;
  private long sent;
  private long confirmed;

  /**
   * @param toAgent the key of the other, by which it knows what comes from here
   * @param now wall time
   */
  Reference(
      AID agent,
      String conversation,
      Holder holder,
      SessionKey toAgent,
      HeartbeatSettings timing,
      Duration now) {
    this.agent = agent;
    this.conversation = conversation;
    this.holder = holder;
    this.toAgent = toAgent;
    this.silence = new Silence(timing, now);
  }

  /** The one referred to; what is asked of it goes there without anybody between. */
  public AID agent() {
    return agent;
  }

  /** Whether it confirms signs of life. Any thread may ask. */
  public Condition condition() {
    return condition;
  }

  String conversation() {
    return conversation;
  }

  Condition look(Duration now) {
    condition = silence.look(now);
    return condition;
  }

  /** The next sign of life, with the key under which it is to be confirmed. */
  Sealed beat() {
    return toAgent.seal(SessionKey.Kind.BEAT, ++sent, fromAgent.write());
  }

  /** Returns false for what is not sealed by the other, or was heard before. */
  boolean confirmed(Sealed answer, Duration now) {
    boolean isNew = answer.number() > confirmed && answer.number() <= sent;
    if (!isNew || !fromAgent.fits(SessionKey.Kind.CONFIRMATION, answer)) {
      return false;
    }
    confirmed = answer.number();
    silence.broken(now);
    condition = Condition.ALIVE;
    return true;
  }

  void lost(String reason) {
    condition = Condition.LOST;
    holder.lost(this, reason);
  }
}
