package org.maestro.troubleshooting;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Pattern;

/** Messages that stand in no Java source: those of the script, of the shapes and of Python. */
final class OtherMessages {
  private static final Pattern OF_SHAPES = Pattern.compile("sh:message \"((?:[^\"\\\\]|\\\\.)*)\"");
  private static final Pattern OF_SCRIPT = Pattern.compile("fail \"([^\"]+)\"");
  private static final Pattern OF_PYTHON =
      Pattern.compile("(?:Refused|Failed|TimedOut|Canceled)\\(\\s*f?\"([^\"]+)\"");
  private static final Path PYTHON = Path.of("rats-bridge/python/src/rats");
  private static final Path ONTOLOGY = Path.of("ontology/src/main/resources/org/maestro/ontology");

  private OtherMessages() {}

  static SortedSet<Message> of(Path root) throws IOException {
    SortedSet<Message> messages = new TreeSet<>();
    for (String shapes : List.of("shapes.ttl", "usual.ttl")) {
      collect(
          root.resolve(ONTOLOGY).resolve(shapes),
          OF_SHAPES,
          "ontology.shapes",
          Kinds.FAULTS,
          messages);
    }
    collect(root.resolve("maestro"), OF_SCRIPT, "script", Kinds.FAILURES, messages);
    try (var files = Files.list(root.resolve(PYTHON))) {
      for (Path file : files.filter(path -> path.toString().endsWith(".py")).toList()) {
        collect(file, OF_PYTHON, "python", Kinds.FAILURES, messages);
      }
    }
    return messages;
  }

  private static void collect(
      Path file, Pattern pattern, String where, String kind, SortedSet<Message> messages) {
    try {
      pattern
          .matcher(Files.readString(file))
          .results()
          .map(
              found ->
                  found
                      .group(1)
                      .replace("\\\"", "\"")
                      .replaceAll("\\$\\{[^}]*}|\\$\\w+|\\{[^}]*}", Message.ANYTHING))
          .map(Wording::cleaned)
          .filter(Wording::says)
          .forEach(text -> messages.add(new Message(where, kind, text)));
    } catch (IOException e) {
      throw new UncheckedIOException(file.toString(), e);
    }
  }
}
