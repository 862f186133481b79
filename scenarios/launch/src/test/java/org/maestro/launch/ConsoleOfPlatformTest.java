package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** A platform serves its console, commands ask it, and so can programs, as the guide shows. */
@Isolated("its time is wall time, which others beside it would take")
class ConsoleOfPlatformTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static final Path DOCS = Path.of("..", "..", "docs");
  private static final String USUAL = "http://127.0.0.1:7070";
  private static final String OF_SECURED = "--cacert";
  private static final Pattern SERVED = Pattern.compile("The console, for a browser: (\\S+)");

  @TempDir private Path directory;

  private record Said(int exitCode, String text) {}

  @Test
  void whatTheGuideShowsIsAnswered() throws Exception {
    try (JavaProcess platform = run("--console", "0")) {
      String console = await(platform, SERVED);
      assertThat(console).matches("http://127\\.0\\.0\\.1:\\d+");
      assumeTrue(isThere("python3"), "The guide's program is not tried: there is no python3.");

      Said reached = bash("python3 docs/examples/goal.py \"(nextTo Cup Bob)\" " + console);
      assertThat(reached.exitCode()).as(reached.text()).isZero();
      assertThat(reached.text()).startsWith("goal ").contains("end      Reached");
      Said refused = bash("python3 docs/examples/goal.py \"(nextT Cup Bob)\" " + console);
      assertThat(refused.exitCode()).isEqualTo(1);
      assertThat(refused.text()).contains("write nextTo, if that is meant");

      assumeTrue(isThere("curl"), "The guide's requests are not tried: there is no curl.");
      List<String> requests =
          requests().stream().filter(request -> !request.contains(OF_SECURED)).toList();
      assertThat(requests).hasSizeGreaterThan(4);
      for (String request : requests) {
        Said answer =
            bash(request.replace("curl ", "curl --silent --show-error ").replace(USUAL, console));
        assertThat(answer.exitCode()).as(request).isZero();
        assertThat(answer.text()).as(request).doesNotContain("\"kind\":\"outside\"");
        if (request.contains("/story") || request.endsWith("/goals")) {
          assertThat(answer.text()).as(request).doesNotContain("\"problem\"");
        }
      }
    }
  }

  @Test
  void whatIsSaidIsDoneAndTold() throws Exception {
    try (JavaProcess platform = run("--console", "0")) {
      await(platform, SERVED);

      assertThat(command("say", "turn on all the lamps in room A", "--as", "Bob", "--in", "room-a"))
          .contains("I will turn on lamp A1 and lamp A2.")
          .contains("Lamp A1 and lamp A2 are on.")
          .doesNotContain("lamp-a1", "G1");
      assertThat(command("say", "why did you do that?", "--as", "Bob", "--in", "room-a"))
          .startsWith("You asked me to turn on lamp A1 and lamp A2, ");
      assertThat(command("say", "never mind", "--as", "Bob", "--in", "room-a"))
          .isEqualTo("There is nothing to call off.");
      assertThat(command("say", "undo that", "--as", "Bob", "--in", "room-a"))
          .as("they were on before")
          .isEqualTo("There is nothing to undo.");
      assertThat(command("say", "turn off lamp A1", "--as", "Bob", "--in", "room-a"))
          .contains("Lamp A1 is off.");
      assertThat(command("say", "undo that", "--as", "Bob", "--in", "room-a"))
          .contains("Lamp A1 is on.");
      assertThat(command("say", "where is Rose?", "--as", "Bob", "--in", "room-a"))
          .isEqualTo("Room B.");
    }
  }

  /** The stations of figure 3 of the ADE paper (A51): what is certain is begun before the end. */
  @Test
  void whatIsSaidWordByWordIsTraced() throws Exception {
    try (JavaProcess platform = run("--console", "0")) {
      await(platform, SERVED);

      assertThat(command("say", "turn off the lamp", "--as", "Bob", "--in", "room-a", "--trace"))
          .contains("9  Which lamp, lamp A1 or lamp A2?");
      assertThat(
              command("say", "turn off lamp A2 please", "--as", "Bob", "--in", "room-a", "--trace")
                  .lines()
                  .map(line -> line.replaceAll("^ *[\\d.]+ +(?=\\d )", "")))
          .containsSubsequence("1  turn", "1  A2", "2  G1 is begun", "4  nods", "1  please")
          .containsSubsequence("3  looks at lamp-a2", "5  (initCNP (:goal (= (level lamp-a2) 0)))")
          .contains("6  G1", "9  Reached, but not seen.")
          .anyMatch(line -> line.startsWith("8  Step 1 of 1: "));
      assertThat(command("say", "undo that", "--as", "Bob", "--in", "room-a"))
          .as("what was said otherwise can be undone here")
          .contains("Lamp A2 is on.");
      assertThat(command("say", "where is Rose?", "--as", "Bob", "--in", "room-a", "--trace"))
          .contains("9  Room B.")
          .containsPattern("Answered \\d+ ms after a word at most, \\d+ ms after the whole");
    }
  }

  /** Lines that come in are said one after the other, each when the one before is answered. */
  @Test
  @Tag("full")
  void linesOfAPipeAreSaidOneAfterTheOther() throws Exception {
    try (JavaProcess platform = run("--console", "0")) {
      await(platform, SERVED);

      JavaProcess.Ended ended =
          chat("printf 'turn on lamp A1\\n\\nwhere is Rose?\\nblorp\\nexit\\nnot said\\n'");
      assertThat(ended.exitCode()).as(ended.errors()).isZero();
      assertThat(ended.output().lines())
          .contains("Room B.", "I do not know the word \"blorp\".")
          .noneMatch(line -> line.contains("not said"));
      assertThat(ended.output().indexOf("I will turn on lamp A1."))
          .isNotNegative()
          .isLessThan(ended.output().indexOf("Room B."));
      assertThat(chat("printf 'where is Rose?'").output()).isEqualTo("Room B.\n");
      try (JavaProcess nobody = maestro(List.of("chat", "--as", "Bo", "--in", "room-a"))) {
        assertThat(nobody.await(LIMIT).errors()).contains("write Bob, if that is meant");
      }
    }
  }

  @Test
  void aPlatformThatGoesAwayEndsTheConversationInOneSentence() throws Exception {
    try (JavaProcess platform = run("--console", "0")) {
      await(platform, SERVED);
      try (JavaProcess chat = talking("printf 'where is Rose?\\n'; exec tail -f /dev/null")) {
        Awaitility.await().atMost(LIMIT).until(() -> chat.output().contains("Room B."));
        platform.kill();
        JavaProcess.Ended ended = chat.await(LIMIT);
        assertThat(ended.exitCode()).isEqualTo(ExitCode.OUTSIDE);
        assertThat(ended.output())
            .isEqualTo(
                "Room B.\nThe platform does not answer any more; the conversation is over.\n");
        assertThat(ended.errors()).isEmpty();
      }
    }
  }

  private JavaProcess.Ended chat(String input) throws Exception {
    try (JavaProcess chat = talking(input)) {
      return chat.await(LIMIT);
    }
  }

  /**
   * @param input what the shell does to make it
   */
  private JavaProcess talking(String input) throws IOException {
    return JavaProcess.start(
        List.of("bash", "-c", "exec \"$0\" \"$@\" < <(" + input + ")"),
        Maestro.class.getName(),
        List.of("chat", "--as", "Bob", "--in", "room-a"),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }

  private static List<String> requests() throws IOException {
    return Files.readAllLines(DOCS.resolve("guide-console.md")).stream()
        .map(String::strip)
        .filter(line -> line.startsWith("curl "))
        .toList();
  }

  @Test
  void withoutAConsoleCommandsAskAllTheSame() throws Exception {
    try (JavaProcess platform = run("--console", "off")) {
      await(platform, Pattern.compile("(It has no console)"));

      assertThat(command("goals"))
          .isEqualTo("No goal was stated yet; try ./maestro goal \"(nextTo Cup Bob)\"");
      assertThat(command("know", "(in rose ?where)")).contains("?where = zone-b");
      assertThat(command("agents")).contains("lamp-b1").doesNotContain("cli-");
    }
  }

  /** It was killed, and its port is another's now; what runs is asked in the other way. */
  @Test
  @Tag("full")
  void whereItsConsoleDoesNotAnswerThePlatformIsAskedAllTheSame() throws Exception {
    try (JavaProcess platform = run("--console", "0")) {
      String console = await(platform, SERVED);
      Path told = directory.resolve("maestro").resolve("maestro.platform.json");
      Files.writeString(told, Files.readString(told).replace(console, "http://127.0.0.1:1"));

      assertThat(command("agents")).contains("lamp-b1").doesNotContain("cli-");
    }
  }

  /** Commands are persons there, and each may what her role says. */
  @Test
  void onASecuredSiteCommandsAskAsPersons() throws Exception {
    String files = directory.resolve("site").toString();
    assertThat(
            command(
                "secure",
                files,
                "bob",
                "--viewer",
                "screen",
                "--operator",
                "alice",
                "--administrator",
                "console"))
        .contains("At the console may sign in: alice (operator), console (administrator)");
    try (JavaProcess platform = run("--console", "0", "--security", files)) {
      String console = await(platform, SERVED);
      assertThat(console).startsWith("https://127.0.0.1:");

      assertThat(command("goals")).startsWith("No goal was stated yet");
      assertThat(command("agents", "--user", "screen")).contains("lamp-b1").doesNotContain("cli-");
      assertThat(command("stop", "--user", "alice")).contains("safe state");
      try (JavaProcess refused = maestro(List.of("stop", "--user", "screen"))) {
        JavaProcess.Ended ended = refused.await(LIMIT);
        assertThat(ended.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(ended.errors()).contains("screen is a viewer here, and this takes an operator");
      }
      assumeTrue(isThere("curl"), "The guide's requests are not tried: there is no curl.");
      List<String> requests =
          requests().stream().filter(request -> request.contains(OF_SECURED)).toList();
      assertThat(requests).isNotEmpty();
      for (String request : requests) {
        Said answer =
            bash(
                request
                    .replace("curl ", "curl --silent --show-error ")
                    .replace("site-files", files)
                    .replace("https" + USUAL.substring("http".length()), console));
        assertThat(answer.text()).as(request).startsWith("{\"goals\":");
      }
    }
  }

  private JavaProcess run(String... more) throws IOException {
    List<String> arguments = new ArrayList<>(List.of("run", "bob", "--port", "0", "--speed", "20"));
    arguments.addAll(List.of(more));
    return maestro(arguments);
  }

  private static String await(JavaProcess platform, Pattern pattern) {
    Awaitility.await()
        .atMost(LIMIT)
        .until(() -> pattern.matcher(platform.output()).find() || !platform.isAlive());
    Matcher found = pattern.matcher(platform.output());
    assertThat(found.find()).as(platform.output() + platform.errors()).isTrue();
    return found.group(1);
  }

  private String command(String... arguments) throws Exception {
    try (JavaProcess process = maestro(List.of(arguments))) {
      JavaProcess.Ended ended = process.await(LIMIT);
      assertThat(ended.exitCode()).as(ended.errors()).isZero();
      return ended.output().strip();
    }
  }

  private JavaProcess maestro(List<String> arguments) throws IOException {
    return JavaProcess.start(
        Maestro.class.getName(), arguments, Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }

  private static boolean isThere(String program) throws Exception {
    return bash("command -v " + program).exitCode() == 0;
  }

  private static Said bash(String line) throws Exception {
    Process process =
        new ProcessBuilder("bash", "-c", line)
            .directory(DOCS.resolve("..").toFile())
            .redirectErrorStream(true)
            .start();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    return new Said(process.waitFor(), text);
  }
}
