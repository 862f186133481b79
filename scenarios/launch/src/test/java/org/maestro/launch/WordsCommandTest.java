package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What goals can be about is listed, and what is written wrongly is told with what is right. */
class WordsCommandTest {

  private static String said(String... arguments) {
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    PrintStream stream = new PrintStream(said, true, StandardCharsets.UTF_8);
    int code = Maestro.commandLine(stream, stream).execute(arguments);
    return code + " " + said.toString(StandardCharsets.UTF_8);
  }

  @Test
  void theWordsOfAHomeAreListedByKind() {
    String words = said("words", "bob");

    assertThat(words).startsWith("0 kind");
    assertThat(words.lines().map(line -> line.replaceAll(" {2,}", " | ")).toList())
        .contains(
            "predicate | (nextTo ?a - Thing ?b - Thing) | next to",
            "number | (illuminance ?z - Location) | illuminance, in lux",
            "place | zone-b | room B: Zone",
            "thing | Cup | the cup: Item",
            "device | rose | Rose: MobileRobot",
            "feature | (pick ?object - Item) | of rose");
    assertThat(said("words", "bob", "--json")).contains("{\"words\":[{\"kind\":\"predicate\"");
  }

  @Test
  void howPeopleCallWhatIsInAHomeIsListed() {
    assertThat(
            said("words", "evening", "--language")
                .lines()
                .map(line -> line.replaceAll(" {2,}", " | "))
                .toList())
        .contains(
            "Name | lounge | (name livingroom)",
            "Noun | light | (noun Lamp)",
            "State | lit | (state lampOn zoneLight)",
            "Preposition | into | (prep in)");
    assertThat(said("words", "--language"))
        .contains("--language goes with a home, such as evening.");
  }

  @Test
  void aCommandThatIsNotThereIsGuessed() {
    assertThat(said("gaol", "(nextTo Cup Bob)"))
        .isEqualToIgnoringNewLines(
            "2 maestro: There is no command gaol; write goal, if that is meant.");
    assertThat(said("frobnicate"))
        .isEqualToIgnoringNewLines(
            "2 maestro: There is no command frobnicate; ./maestro --help lists those there are.");
  }

  @Test
  void theVersionIsTold() {
    assertThat(said("--version")).matches("0 MAESTRO \\d+\\.\\d+\\.\\d+\\S* on Java \\d+\\S*\\s+");
  }

  @Test
  void wordsWithoutBracketsGetThem() {
    List.of("plan", "know")
        .forEach(
            command ->
                assertThat(
                        command.equals("plan")
                            ? said(command, "bob", "nextTo Cup Bob")
                            : said(command, "nextTo Cup Bob"))
                    .isEqualToIgnoringNewLines(
                        "2 maestro: At column 1 \"(\", as in (nextTo Cup Bob), was expected, but"
                            + " found \"nextTo\"."));
  }
}
