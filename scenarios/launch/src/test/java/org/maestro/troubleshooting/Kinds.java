package org.maestro.troubleshooting;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** What each kind of message means: of an error type of the code, what its Javadoc begins with. */
final class Kinds {
  static final String FAULTS = "faults";
  static final String FAILURES = "refusals and failures";
  static final String LOG = "the log";
  static final String PARTS = "parts";
  static final String SENTENCES = "sentences";

  private static final Pattern JAVADOC =
      Pattern.compile(
          "/\\*\\*((?:(?!\\*/).)*)\\*/\\s*(?:@\\w+\\S*\\s+)*(?:[a-z]+ )*class (\\w+Exception)",
          Pattern.DOTALL);
  private static final List<String> LATER = List.of(FAULTS, FAILURES, LOG, PARTS, SENTENCES);

  private final Map<String, String> meanings =
      new HashMap<>(
          Map.of(
              FAULTS,
              "Faults and doubts of a file or a description; file, line and word stand before, the cure behind the semicolon",
              FAILURES,
              "Refusals and failures, alone or as the reason in a longer sentence",
              LOG,
              "Warnings and errors in the log",
              SENTENCES,
              "Said or answered otherwise",
              PARTS,
              "Parts of longer sentences",
              "IllegalArgumentException",
              "A value that cannot be",
              "IllegalStateException",
              "What is not to happen: keep the log and what `--debug` prints, and report it"));

  private Kinds() {}

  static Kinds of(Path root) throws IOException {
    Kinds kinds = new Kinds();
    try (Stream<Path> files = Files.walk(root)) {
      for (Path file : files.filter(path -> path.toString().endsWith("Exception.java")).toList()) {
        Matcher javadoc = JAVADOC.matcher(Files.readString(file));
        if (javadoc.find()) {
          kinds.meanings.put(javadoc.group(2), firstSentence(javadoc.group(1)));
        }
      }
    }
    return kinds;
  }

  private static String firstSentence(String javadoc) {
    String text = javadoc.replaceAll("\\n\\s*\\*", " ").replaceAll("\\s+", " ").strip();
    return text.replaceAll("(\\.|; the message (is|says)|; names)( .*)?$", "");
  }

  /** For people: the error type, if it is one of the code, and what it means. */
  String heading(String kind) {
    String meaning =
        meanings.getOrDefault(kind, "Other errors, some of them handed on to a library");
    return LATER.contains(kind) || !meanings.containsKey(kind)
        ? meaning + ":"
        : "`%s`: %s:".formatted(kind, meaning);
  }

  /** Error types of the code come first, those of libraries last. */
  int rank(String kind) {
    return LATER.contains(kind) ? 1 + LATER.indexOf(kind) : meanings.containsKey(kind) ? 0 : 9;
  }
}
