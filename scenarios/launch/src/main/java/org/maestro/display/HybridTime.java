package org.maestro.display;

import ch.qos.logback.classic.pattern.ClassicConverter;
import ch.qos.logback.classic.spi.ILoggingEvent;
import org.maestro.rats.time.HybridClock;

/**
 * The converter for the time of a log's line by the hybrid clock of its process: an effect is dated
 * later than its cause, also in another process whose machine's clock is slow (ADE, 3.3; A43).
 */
public final class HybridTime extends ClassicConverter {
  /** Under which a log's context has another clock than that of this process. */
  public static final String CLOCK = "maestro-hybrid-clock";

  /** It is called while the line is written, one line after the other. */
  @Override
  public String convert(ILoggingEvent event) {
    Object own = getContext().getObject(CLOCK);
    return (own instanceof HybridClock clock ? clock : HybridClock.ofProcess()).now().toString();
  }
}
