package org.maestro.launch;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.maestro.display.VisibleText;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Stands in for stdout and stderr, to which libraries print what people cannot use: it goes to the
 * log. Lines that begin like our own warnings pass.
 */
final class StrayOutput extends OutputStream {
  private static final String OWN = "maestro: ";

  private final PrintStream people;
  private final ByteArrayOutputStream line = new ByteArrayOutputStream();

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
