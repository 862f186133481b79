package org.maestro.launch;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.maestro.text.VisibleText;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Stands in for stdout and stderr, to which libraries print what people cannot use: it goes to the
 * log. Lines that begin like our own warnings pass.
 */
final class StrayOutput extends OutputStream {
  private static final String OWN = "maestro: ";

  /** What JADE prints, with its stack, when containers leave in order, or all end at once. */
  private static final List<String> ORDERLY_ENDS =
      List.of(
          "java.io.EOFException: EOF reading packet header",
          "jade.core.NotFoundException: No container named ");

  private static final String FRAME = "\tat ";

  private final PrintStream people;
  private final ByteArrayOutputStream line = new ByteArrayOutputStream();
  private boolean withinEnd;

  private StrayOutput(PrintStream people) {
    this.people = people;
  }

  static PrintStream before(PrintStream people) {
    return new PrintStream(new StrayOutput(people), true, StandardCharsets.UTF_8);
  }

  @Override
  public synchronized void write(int character) {
    if (character != '\n') {
      line.write(character);
      return;
    }
    String text = line.toString(StandardCharsets.UTF_8).stripTrailing();
    line.reset();
    withinEnd =
        ORDERLY_ENDS.stream().anyMatch(text::startsWith) || withinEnd && text.startsWith(FRAME);
    if (withinEnd) {
      return;
    }
    if (text.startsWith(OWN)) {
      people.println(VisibleText.line(text));
    } else if (!text.isEmpty()) {
      log().info(text);
    }
  }

  private static Logger log() {
    return LoggerFactory.getLogger("stray");
  }
}
