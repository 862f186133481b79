package org.maestro.launch;

import java.io.Console;
import java.io.PrintWriter;
import java.util.Locale;
import java.util.Optional;
import org.maestro.experiment.running.Progress;
import org.maestro.text.VisibleText;

/** A bar that grows while an experiment runs; a line for each run where there is no terminal. */
final class ProgressBar implements Progress {
  private static final int LENGTH = 30;
  private static final int LINE = 100;

  private final PrintWriter people;
  private final Optional<PrintWriter> terminal =
      Optional.ofNullable(System.console()).map(Console::writer);
  private final long begun = System.nanoTime();

  ProgressBar(PrintWriter people) {
    this.people = people;
  }

  @Override
  public void passed(int done, int of, String line) {
    if (terminal.isEmpty()) {
      people.println("%d of %d: %s".formatted(done, of, line));
      people.flush();
      return;
    }
    int full = LENGTH * done / of;
    double left = (System.nanoTime() - begun) / 1e9 / done * (of - done);
    String text =
        String.format(
            Locale.ROOT,
            "[%s%s] %d of %d, %.0f s left: %s",
            "#".repeat(full),
            ".".repeat(LENGTH - full),
            done,
            of,
            left,
            line);
    String shown = VisibleText.line(text);
    PrintWriter bar = terminal.get();
    bar.print("\r" + shown.substring(0, Math.min(LINE, shown.length())) + "\u001b[K");
    if (done == of) {
      bar.println();
    }
    bar.flush();
  }

  /** Nothing more comes: what is told next begins a line. */
  void breakOff() {
    terminal.ifPresent(
        bar -> {
          bar.println();
          bar.flush();
        });
  }
}
