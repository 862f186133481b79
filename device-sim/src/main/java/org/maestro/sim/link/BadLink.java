package org.maestro.sim.link;

import java.time.Duration;
import java.util.Random;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Transport;

/**
 * Loss, repetition and delay on the link of one member, whatever transport it has now. In the
 * beginning it is good. Any thread may call it.
 */
public final class BadLink {

  private final String member;
  private final Clock clock;
  private final Random random;
  private double loss;
  private double repetition;
  private Duration delay = Duration.ZERO;
  private Duration lastArrival = Duration.ZERO;

  /**
   * @param random draws nothing while the link is good
   */
  public BadLink(String member, Clock clock, Random random) {
    this.member = member;
    this.clock = clock;
    this.random = random;
  }

  /** The share of messages, both ways, that never arrive; 1 is a link that is down silently. */
  public synchronized void lose(double share) {
    loss = share;
  }

  /** The share of messages, both ways, that arrive twice. */
  public synchronized void repeat(double share) {
    repetition = share;
  }

  /** Every message, both ways, takes so much longer; their order stays. */
  public synchronized void delay(Duration longer) {
    delay = longer;
  }

  /** A transport whose messages go by this link. */
  public Transport over(Transport transport) {
    return new BadTransport(transport, this);
  }

  /** How often a message arrives: not at all, once or twice. */
  synchronized int copies() {
    if (loss > 0 && random.nextDouble() < loss) {
      return 0;
    }
    return repetition > 0 && random.nextDouble() < repetition ? 2 : 1;
  }

  /** Lets a message pass, now if the link is quick. */
  void pass(Runnable message) {
    Duration wait = wait(clock.now());
    if (wait.isZero()) {
      message.run();
    } else {
      clock.schedule(wait, member, message);
    }
  }

  private synchronized Duration wait(Duration now) {
    if (delay.isZero() && lastArrival.compareTo(now) <= 0) {
      return Duration.ZERO;
    }
    Duration arrival = now.plus(delay);
    lastArrival = arrival.compareTo(lastArrival) < 0 ? lastArrival : arrival;
    return lastArrival.minus(now);
  }
}
