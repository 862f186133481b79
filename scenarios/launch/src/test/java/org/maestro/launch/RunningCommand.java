package org.maestro.launch;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.time.Duration;
import org.awaitility.Awaitility;

/**
 * A command that stays, on a thread of its own, until it is closed, also when the test has failed.
 */
final class RunningCommand implements AutoCloseable {
  private final ByteArrayOutputStream words = new ByteArrayOutputStream();
  private final Thread thread;

  RunningCommand(String... arguments) {
    PrintStream out = new PrintStream(words, true, UTF_8);
    thread = new Thread(() -> Maestro.commandLine(out, out).execute(arguments), arguments[0]);
    thread.setDaemon(true);
    thread.start();
  }

  String said() {
    return words.toString(UTF_8);
  }

  @Override
  public void close() {
    thread.interrupt();
    Awaitility.await().atMost(Duration.ofSeconds(60)).until(() -> !thread.isAlive());
  }
}
