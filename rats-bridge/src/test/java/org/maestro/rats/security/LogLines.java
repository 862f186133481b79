package org.maestro.rats.security;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.util.List;
import org.slf4j.LoggerFactory;

/** What a class warns of in the log meanwhile. */
final class LogLines implements AutoCloseable {

  private final Logger logger;
  private final ListAppender<ILoggingEvent> appender = new ListAppender<>();

  private LogLines(String of) {
    logger = (Logger) LoggerFactory.getLogger(of);
    appender.start();
    logger.setLevel(Level.WARN);
    logger.addAppender(appender);
  }

  static LogLines of(Class<?> writer) {
    return of(writer.getName());
  }

  /**
   * @param writer the name of a class that is not seen from here
   */
  static LogLines of(String writer) {
    return new LogLines(writer);
  }

  List<String> lines() {
    return List.copyOf(appender.list).stream().map(ILoggingEvent::getFormattedMessage).toList();
  }

  @Override
  public void close() {
    logger.detachAppender(appender);
    logger.setLevel(null);
  }
}
