package org.maestro.guide;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.TextNode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.launch.JavaProcess;
import org.maestro.rats.broker.EmbeddedBroker;

/**
 * A device, and people, that say what terminals, logs and pages obey: every byte that the commands,
 * the log and the stories then have is one that is seen, and the documents hold what was said.
 */
@Tag("full")
class HostileWordsTest {
  private static final Duration LIMIT = Duration.ofSeconds(90);
  private static final String EVIL =
      "\u001b[2J\u001b]0;owned\u0007\r\nFAKE 12:00 Reached.\u202egnp.exe\u2066\u009b31m\u0000\u007f"
          + "\"')(\\<script>\u2028\u2029\u0085\u00ad\ufeff\udb40\udc41\nFAKE";

  /** As a line of the platform's own would begin; those that are wrapped are indented by more. */
  private static final Pattern FORGED = Pattern.compile("(?m)^ {0,8}FAKE");

  private static final ObjectMapper JSON = new ObjectMapper();

  @TempDir private Path directory;

  private final List<String> seen = new ArrayList<>();

  @Test
  void nothingThatIsSaidIsObeyed() throws Exception {
    PythonProcess.assumePython();
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        JavaProcess platform =
            maestro(
                "run",
                home().toString(),
                "--no-sim",
                "--broker",
                broker.uri().toString(),
                "--port",
                "0",
                "--speed",
                "20");
        PythonProcess device =
            new PythonProcess("hostile.py", directory, broker.uri(), "maestro", escaped(EVIL))) {
      awaitOutput(platform, "The platform maestro runs");
      Awaitility.await()
          .atMost(LIMIT)
          .until(() -> said("agents", "--json").output().contains("hostile-1"));

      List<JsonNode> documents = new ArrayList<>();
      assertThat(said("goal", "(bright Box)").output()).contains("Not reached");
      documents.add(document("goal", "(bright Box)", "--json"));
      assertThat(documents.get(0).at("/reasons").toString()).contains(escapedInner());
      assertThat(said("goal", "(bright Chest)").output())
          .as("a refusal that is too long is told as such")
          .contains("cannot be read", "at most 8192 characters")
          .doesNotContain("gave no answer");
      assertThat(said("goal", "(>= (weight Box) 3)").output()).contains("has to be a number");
      documents.add(document("goal", "(>= (weight Box) 3)", "--json"));
      String typed = EVIL.replace("\u0000", "");
      for (String goal :
          List.of(
              typed,
              "(bright " + typed + ")",
              "(bright \"" + typed.replaceAll("[\"\\\\]", "") + "\")")) {
        assertThat(said("goal", goal).exitCode()).isEqualTo(2);
        assertThat(said("goal", goal, "--json").exitCode()).isEqualTo(2);
        assertThat(said("know", goal).exitCode()).isEqualTo(2);
      }
      assertThat(said("why", typed).exitCode()).isEqualTo(2);
      assertThat(said("goal", "(bright Box)", "--deadline", typed).exitCode()).isEqualTo(2);
      assertThat(said(typed).exitCode()).isEqualTo(2);
      for (String goal : List.of("G1", "G3")) {
        said("why", goal);
        documents.add(document("why", goal, "--json"));
      }
      assertThat(documents.get(2).toString()).contains(escapedInner());
      for (String[] command :
          List.of(
              new String[] {"agents"},
              new String[] {"agents", "--containers"},
              new String[] {"goals"},
              new String[] {"know", "(= (weight Box) ?n)"},
              new String[] {"know", "(bright ?what)"})) {
        said(command);
        List<String> asDocument = new ArrayList<>(List.of(command));
        asDocument.add("--json");
        documents.add(document(asDocument.toArray(String[]::new)));
      }
      assertThat(device.lines("polish")).isNotEmpty();
      assertThat(device.lines("weigh")).isNotEmpty();
      look("run", platform.output());
      look("run's errors", platform.errors());
    }
    List<Path> files;
    try (Stream<Path> all = Files.walk(directory.resolve("maestro"))) {
      files = all.filter(Files::isRegularFile).toList();
    }
    assertThat(files.stream().map(file -> file.getFileName().toString()))
        .contains("maestro.log", "G1.jsonl");
    for (Path file : files) {
      String text = decoded(Files.readAllBytes(file));
      look(file.getFileName().toString(), text);
      if (file.toString().endsWith(".jsonl")) {
        for (String line : text.lines().toList()) {
          JSON.readTree(line);
        }
      }
    }
    assertThat(seen).as("what is obeyed, and where").isEmpty();
  }

  /** Exactly what was said stands in it. */
  private static String escapedInner() {
    String text = TextNode.valueOf(EVIL).toString();
    return text.substring(1, text.length() - 1);
  }

  /** In ASCII. */
  private static String escaped(String text) {
    StringBuilder escaped = new StringBuilder("\"");
    text.chars().forEach(c -> escaped.append("\\u%04x".formatted(c)));
    return escaped.append('"').toString();
  }

  private JsonNode document(String... command) throws Exception {
    JavaProcess.Ended ended = said(command);
    assertThat(ended.output().lines()).as(String.join(" ", command) + ended).hasSize(1);
    return JSON.readTree(ended.output());
  }

  private JavaProcess.Ended said(String... command) throws Exception {
    try (JavaProcess process = maestro(command)) {
      JavaProcess.Ended ended = process.await(LIMIT);
      look(String.join(" ", command), ended.output());
      look(String.join(" ", command), ended.errors());
      return ended;
    }
  }

  private void look(String where, String text) {
    text.codePoints()
        .filter(HostileWordsTest::isObeyed)
        .distinct()
        .forEach(c -> seen.add("U+%04X in %s".formatted(c, escaped(where))));
    FORGED
        .matcher(text)
        .results()
        .forEach(forged -> seen.add("a line of its own in " + escaped(where)));
  }

  private static boolean isObeyed(int character) {
    return switch (Character.getType(character)) {
      case Character.CONTROL -> character != '\n' && character != '\t';
      case Character.FORMAT,
          Character.LINE_SEPARATOR,
          Character.PARAGRAPH_SEPARATOR,
          Character.SURROGATE,
          Character.UNASSIGNED ->
          true;
      default -> false;
    };
  }

  private static String decoded(byte[] bytes) throws IOException {
    return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
  }

  private static void awaitOutput(JavaProcess process, String expected) {
    Awaitility.await()
        .atMost(LIMIT)
        .until(() -> process.output().contains(expected) || !process.isAlive());
  }

  private Path home() throws IOException {
    try (InputStream text = HostileWordsTest.class.getResourceAsStream("/homes/odd.ttl")) {
      return Files.writeString(
          directory.resolve("odd.ttl"),
          new String(text.readAllBytes(), StandardCharsets.UTF_8) + "home:Chest a home:Load .\n");
    }
  }

  private JavaProcess maestro(String... arguments) throws IOException {
    return JavaProcess.startLogging(
        "org.maestro.launch.Maestro",
        List.of(arguments),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }
}
