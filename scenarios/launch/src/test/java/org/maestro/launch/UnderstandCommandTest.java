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
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Words are understood in the evening's house, from the command line. */
class UnderstandCommandTest {
  private static final Pattern USED =
      Pattern.compile("rules of the grammar en are used .*\\((\\d+) %\\)");

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
  @ParameterizedTest
  @ValueSource(strings = {"evening.tsv", "wordings.tsv", "rules.tsv"})
  void eachUtteranceOfTheListMeansWhatStandsBesideIt(String list) throws IOException {
    isUnderstoodAsItSays(list, "--scene", "evening", "--to", "rob");
  }

  /** What a household has is called in German, too. */
  @ParameterizedTest
  @ValueSource(strings = {"evening", "rooms"})
  void germanIsSpokenInAHousehold(String home) throws IOException {
    isUnderstoodAsItSays(
        "german-" + home + ".tsv", "--home", home, "--scene", home, "--language", "de");
  }

  private void isUnderstoodAsItSays(String list, String... there) throws IOException {
    List<String> lines = new ArrayList<>();
    List<String> expected = new ArrayList<>();
    for (String line : resource(list).lines().filter(one -> !one.startsWith("#")).toList()) {
      String[] columns = line.split("\t", -1);
      lines.add(String.join("\t", columns[0], columns[1], columns[2], columns[3]));
      expected.add(columns[0] + " => " + columns[4]);
    }
    Path file = Files.writeString(directory.resolve("said.tsv"), String.join("\n", lines));

    List<String> arguments = new ArrayList<>(List.of("understand", "--json"));
    arguments.addAll(List.of(there));
    arguments.addAll(List.of("--file", file.toString()));
    String printed = Printed.by(arguments.toArray(String[]::new));

    List<String> understood = new ArrayList<>();
    for (String document : printed.lines().toList()) {
      JsonNode one = JSON.readTree(document);
      understood.add(one.path("utterance").asText() + " => " + meantOrAsked(one));
    }
    assertThat(understood).containsExactlyElementsOf(expected);
  }

  /** Which rules nobody has tried is told, so that who writes a grammar can. */
  @Test
  void mostRulesOfTheGrammarAreTriedByTheLists() throws IOException {
    String all = resource("evening.tsv") + resource("wordings.tsv") + resource("rules.tsv");
    Path file = Files.writeString(directory.resolve("all.tsv"), all);

    String printed =
        Printed.by(
            "understand",
            "--scene",
            "evening",
            "--to",
            "rob",
            "--unused",
            "--file",
            file.toString());

    Matcher share = USED.matcher(printed);
    assertThat(share.find()).as(printed).isTrue();
    assertThat(Integer.parseInt(share.group(1))).isGreaterThanOrEqualTo(70);
    assertThat(printed).contains("unused, line ").doesNotContain(": Act = Can you Vp");
  }

  private static String meantOrAsked(JsonNode document) {
    if (!document.path("meaning").isNull()) {
      return document.path("meaning").asText();
    }
    return "- "
        + (document.path("question").isNull() ? document.path("reply") : document.path("question"))
            .asText();
  }

  private static String resource(String name) throws IOException {
    try (InputStream stream = UnderstandCommandTest.class.getResourceAsStream(name)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  @Test
  void whatTurnsOutToBeMeantOtherwiseIsCalledOff() throws IOException {
    JsonNode later =
        CommandSchemas.valid(
            "understand",
            Printed.by(
                "understand", "turn on the kitchen light at 10 pm", "--at", "18:00", "--json"));

    assertThat(later.path("meaning").asText()).startsWith("(at 1320 ");
    assertThat(later.path("began").get(0).path("after").asText()).isEqualTo("light");
    assertThat(later.path("began").get(0).path("calledOff").asText()).isEqualTo("10");
    assertThat(Printed.by("understand", "if the oven is hot", "--json")).contains("\"began\":[]");
  }

  /** Thirty may be degrees, percent, or minutes. */
  @Test
  void aNumberWaitsForItsUnit() {
    assertThat(Printed.by("understand", "set the bedroom to 30 percent", "--json"))
        .contains("\"meaning\":null", "\"began\":[]");
    assertThat(Printed.by("understand", "set the bedroom to 30 degrees", "--json"))
        .contains("\"after\":\"degrees\"", "\"calledOff\":null")
        .doesNotContain("\"after\":\"30\"");
  }

  @Test
  void everythingIsSwitchedOffOnlyAfterAYes() throws IOException {
    Path file =
        Files.writeString(
            directory.resolve("said.tsv"), "yes\tDave\tlivingroom\tturn off everything");

    assertThat(Printed.by("understand", "--scene", "evening", "--file", file.toString()))
        .contains("(= (level ceiling-living) 0)", "(not (switchedOn stereo))");
  }

  /** What follows a yes may take it back: of course not. */
  @Test
  void whatWasAskedBackIsNotBegunBeforeTheAnswerEnds() throws IOException {
    Path file =
        Files.writeString(
            directory.resolve("said.tsv"),
            "yes, of course\tDave\tkitchen\tturn on the oven\n"
                + "of course not\tDave\tkitchen\tturn on the oven");

    List<String> printed =
        Printed.by("understand", "--scene", "evening", "--json", "--file", file.toString())
            .lines()
            .toList();

    assertThat(printed.get(0)).contains("(switchedOn oven)", "\"began\":[]");
    assertThat(printed.get(1)).contains("All right.", "\"began\":[]");
  }

  /** ADE, 4.2: one glass stands on the table and one on the floor. */
  @Test
  void theGlassOnTheFloorIsFoundWordByWord() throws IOException {
    List<String> rows =
        inTheKitchen("put the glass on the floor in the refrigerator", "--words")
            .lines()
            .map(line -> line.strip().replaceAll("\\s{2,}", " | "))
            .toList();

    assertThat(rows)
        .containsSubsequence(
            "glass | putting | object: glass-1, glass-2; where: ?",
            "floor | putting | object: glass-1, glass-2; where: floor-k | looks at glass-2; looks at"
                + " floor-k",
            "putting | object: glass-2; where: ?",
            "refrigerator | putting | object: glass-2; where: refrigerator | begins (in glass-2"
                + " refrigerator); looks at refrigerator; nods",
            "means | (initCNP (:goal (in glass-2 refrigerator)))");
    assertThat(inTheKitchen("put the glass on the floor"))
        .contains("(initCNP (:goal (on glass-1 floor-k)))");
    assertThat(inTheKitchen("put the glass in the refrigerator"))
        .contains("asks   Which glass, the one on the table or the one on the floor?");
    assertThat(
            afterwards(
                "no, just dump it in the sink", "put the glass on the floor in the refrigerator"))
        .contains("(initCNP (:goal (in glass-2 sink)))");
    assertThat(afterwards("the one on the table", "put the glass in the refrigerator"))
        .contains("(initCNP (:goal (in glass-1 refrigerator)))");
  }

  private static String inTheKitchen(String words, String... more) {
    List<String> arguments =
        new ArrayList<>(
            List.of("understand", words, "--scene", "glasses", "--as", "Dave", "--in", "kitchen"));
    arguments.addAll(List.of(more));
    return Printed.by(arguments.toArray(String[]::new));
  }

  private String afterwards(String words, String before) throws IOException {
    Path file =
        Files.writeString(
            directory.resolve("said.tsv"), String.join("\t", words, "Dave", "kitchen", before));
    return Printed.by("understand", "--scene", "glasses", "--file", file.toString());
  }

  @Test
  void whatIsGivenWronglyIsTold() {
    assertThat(refused("understand")).contains("Give words in quotes, or --file, or --type");
    assertThat(refused("understand", "--type", "--json")).contains("leave --words, --json and");
    assertThat(refused("understand", "hello", "--in", "attic")).contains("The home has no attic");
    assertThat(refused("understand", "hello", "--at", "soon")).contains("--at soon is no time");
  }
}
