package org.maestro.display;

import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.pattern.CompositeConverter;
import org.maestro.text.VisibleText;

/**
 * The converter of a log's lines: {@code %visible(%msg){line}} is one line whatever the message
 * holds, {@code %visible(%ex){lines}} as many as a stack trace has.
 */
public final class VisibleLog extends CompositeConverter<ILoggingEvent> {
  @Override
  protected String transform(ILoggingEvent event, String text) {
    return "lines".equals(getFirstOption()) ? VisibleText.lines(text) : VisibleText.line(text);
  }
}
