package org.maestro.launch;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.slf4j.LoggerFactory;

class StrayOutputTest {
  private final Logger stray = (Logger) LoggerFactory.getLogger("stray");
  private final Level formerLevel = stray.getLevel();
  private final ListAppender<ILoggingEvent> log = new ListAppender<>();
  private final ByteArrayOutputStream people = new ByteArrayOutputStream();
  private final PrintStream output = StrayOutput.before(new PrintStream(people, true, UTF_8));

  @BeforeEach
  void listen() {
    log.start();
    stray.addAppender(log);
    stray.setLevel(Level.INFO);
    stray.setAdditive(false);
  }

  @AfterEach
  void stopListening() {
    stray.detachAppender(log);
    stray.setLevel(formerLevel);
    stray.setAdditive(true);
  }

  @Test
  void peopleSeeOurOwnLinesOnly() {
    output.println("maestro: a sentence");
    output.println("a library's chatter");
    assertThat(people.toString(UTF_8)).isEqualTo("maestro: a sentence\n");
    assertThat(log.list)
        .extracting(ILoggingEvent::getFormattedMessage)
        .containsExactly("a library's chatter");
  }

  @Test
  void orderlyEndsOfContainersLeaveNoStackTrace() {
    output.println("java.io.EOFException: EOF reading packet header");
    output.println("\tat jade.imtp.leap.JICP.JICPPacket.read(JICPPacket.java:335)");
    output.println("jade.core.NotFoundException: No container named lights was found.");
    output.println("\tat jade.core.ContainerTable.getMTPs(ContainerTable.java:98)");
    assertThat(log.list).isEmpty();
  }

  @Test
  void otherStackTracesAreKept() {
    output.println("java.io.EOFException: EOF reading packet header");
    output.println("java.lang.IllegalStateException: something else");
    output.println("\tat some.Place.where(Place.java:1)");
    assertThat(log.list).hasSize(2);
  }
}
