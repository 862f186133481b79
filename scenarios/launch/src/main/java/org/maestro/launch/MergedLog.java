package org.maestro.launch;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.rats.time.HybridStamp;

/**
 * The lines of several processes' logs in one order: by the hybrid clocks of the processes, so that
 * no line stands before one that it follows from (ADE, 3.3; A43).
 */
final class MergedLog {
  private final List<Entry> entries = new ArrayList<>();
  private int undated;

  /**
   * A line, with those that belong to it, such as a stack trace.
   *
   * @param source whose it is
   */
  private record Entry(HybridStamp at, String source, List<String> lines) {}

  /**
   * Adds all lines of a file.
   *
   * @param source by which its lines are told from others
   */
  void add(String source, Path file) throws IOException {
    Optional<Entry> last = Optional.empty();
    String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
    for (String line : text.lines().toList()) {
      Optional<HybridStamp> at = HybridStamp.read(line.split(" ", 2)[0]);
      if (at.isPresent()) {
        last = Optional.of(new Entry(at.get(), source, new ArrayList<>(List.of(line))));
        entries.add(last.get());
      } else {
        undated += last.isPresent() ? 0 : 1;
        last.ifPresent(entry -> entry.lines().add(line));
      }
    }
  }

  /** How many lines stand at the beginning of files and have no time by which to order them. */
  int undated() {
    return undated;
  }

  /** Prints them all, each after the name of its source. */
  void print(Consumer<String> out) {
    int width = entries.stream().mapToInt(entry -> entry.source().length()).max().orElse(0);
    entries.stream()
        .sorted(Comparator.comparing(Entry::at))
        .forEach(
            entry ->
                entry
                    .lines()
                    .forEach(
                        line ->
                            out.accept(
                                entry.source()
                                    + " ".repeat(width - entry.source().length() + 1)
                                    + line)));
  }
}
