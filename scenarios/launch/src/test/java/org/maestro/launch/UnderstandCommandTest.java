package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Words are understood in the evening's house, from the command line. */
class UnderstandCommandTest {
  private static final ObjectMapper JSON = new ObjectMapper();

  @TempDir Path directory;

  private static String refused(String... arguments) {
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    PrintStream stream = new PrintStream(said, true, StandardCharsets.UTF_8);
    assertThat(Maestro.commandLine(stream, stream).execute(arguments))
        .isEqualTo(ExitCode.BAD_INPUT);
    return said.toString(StandardCharsets.UTF_8);
  }

  @Test
  void whatIsUnderstoodIsPrintedAsItsSchemaSays() throws IOException {
    String printed =
        Printed.by(
            "understand", "turn on the kitchen light, please", "--in", "livingroom", "--json");

    JsonNode document = CommandSchemas.valid("understand", printed);
    assertThat(document.path("meaning").asText())
        .isEqualTo("(initCNP (:goal (= (level kitchen-lamp) 1)))");
    assertThat(document.path("began").get(0).path("after").asText()).isEqualTo("light");
  }

  /**
   * A line each: utterance, speaker, room, what was said before, and the message or the question.
   */
  @Test
  void eachUtteranceOfTheListMeansWhatStandsBesideIt() throws IOException {
    List<String> lines = new ArrayList<>();
    List<String> expected = new ArrayList<>();
    for (String line : resource().lines().filter(one -> !one.startsWith("#")).toList()) {
      String[] columns = line.split("\t", -1);
      lines.add(String.join("\t", columns[0], columns[1], columns[2], columns[3]));
      expected.add(columns[0] + " => " + columns[4]);
    }
    Path file = Files.writeString(directory.resolve("said.tsv"), String.join("\n", lines));

    String printed =
        Printed.by(
            "understand", "--scene", "evening", "--to", "rob", "--file", file.toString(), "--json");

    List<String> understood = new ArrayList<>();
    for (String document : printed.lines().toList()) {
      JsonNode one = JSON.readTree(document);
      understood.add(one.path("utterance").asText() + " => " + meantOrAsked(one));
    }
    assertThat(understood).containsExactlyElementsOf(expected);
  }

  private static String meantOrAsked(JsonNode document) {
    if (!document.path("meaning").isNull()) {
      return document.path("meaning").asText();
    }
    return "- "
        + (document.path("question").isNull() ? document.path("reply") : document.path("question"))
            .asText();
  }

  private static String resource() throws IOException {
    try (InputStream stream = UnderstandCommandTest.class.getResourceAsStream("evening.tsv")) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  @Test
  void whatIsGivenWronglyIsTold() {
    assertThat(refused("understand")).contains("Give words in quotes, or --file, not both.");
    assertThat(refused("understand", "hello", "--in", "attic")).contains("The home has no attic");
    assertThat(refused("understand", "hello", "--at", "soon")).contains("--at soon is no time");
  }
}
