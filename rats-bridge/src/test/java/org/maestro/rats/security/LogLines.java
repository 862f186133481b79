package org.maestro.rats.security;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.slf4j.LoggerFactory;

/** The warnings of a class or a package meanwhile; they are kept here and not written out. */
public final class LogLines implements AutoCloseable {

  private final Logger logger;
  private final @Nullable Level formerLevel;
  private final ListAppender<ILoggingEvent> appender = new ListAppender<>();

  private LogLines(String of) {
    logger = (Logger) LoggerFactory.getLogger(of);
    formerLevel = logger.getLevel();
    appender.start();
    logger.addAppender(appender);
    logger.setLevel(Level.WARN);
    logger.setAdditive(false);
  }

  static LogLines of(Class<?> writer) {
    return of(writer.getName());
  }

  /**
   * @param writer the name of a class that is not seen from here, or of a package
   */
  public static LogLines of(String writer) {
    return new LogLines(writer);
  }

  public List<String> lines() {
    return events().stream().map(ILoggingEvent::getFormattedMessage).toList();
  }

  public List<ILoggingEvent> events() {
    return List.copyOf(appender.list);
  }

  @Override
  public void close() {
    logger.detachAppender(appender);
    logger.setLevel(formerLevel);
    logger.setAdditive(true);
  }
}
