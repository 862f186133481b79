package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Lines of the language are shown as they are understood, with what is wrong in them. */
class SlCommandTest {

  private static List<String> said(String... arguments) {
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    PrintStream stream = new PrintStream(said, true, StandardCharsets.UTF_8);
    int code = Maestro.commandLine(stream, stream).execute(arguments);
    String text = code + "\n" + said.toString(StandardCharsets.UTF_8);
    return text.lines().map(line -> line.replaceAll("(?<=\\S) {2,}", " | ")).toList();
  }

  @Test
  void aGoalIsTakenApart() {
    assertThat(said("sl", "(not (nextTo Cup ?who))"))
        .containsExactly(
            "0",
            "a goal or condition",
            "part | role | word",
            "not | this does not hold",
            "  nextTo | holds | predicate (nextTo ?a - Thing ?b - Thing): next to",
            "    Cup | a name | thing Cup: the cup: Item",
            "    ?who | whichever fits",
            "");
  }

  @Test
  void effectsAndNumbersAreToldApart() {
    assertThat(said("sl", "(sense (illuminance zone-a))", "(+ 1 (level lamp-b1))"))
        .contains(
            "an effect",
            "sense | finds out the number",
            "  illuminance | a number | number (illuminance ?z - Location): illuminance, in lux",
            "a number",
            "+ | reckons with these");
  }

  @Test
  void whatIsWrongIsSaid() {
    assertThat(said("sl", "(nextTo Cup", "(nextTo Cup zone-a)"))
        .startsWith("1")
        .contains(
            "At column 12 the \")\" for the \"(\" at column 1 was expected, but found the end of the text.",
            "The line names zone-a where a Thing is wanted, and it is none; write (nextTo ?a - Thing ?b - Thing).");
  }

  @Test
  void unknownWordsOfEffectsAndNumbersAreFaults() {
    assertThat(said("sl", "(increase (levle lamp-b1) 1)"))
        .startsWith("1", "an effect")
        .contains("The line uses the unknown fluent levle; write level, if that is meant.");
    assertThat(said("sl", "(sense (nextto ?object Bob))"))
        .startsWith("1", "an effect")
        .contains("The line uses the unknown predicate nextto; write nextTo, if that is meant.");
    assertThat(said("sl", "(+ 1 (level lamp-b9))"))
        .startsWith("1", "a number")
        .anyMatch(line -> line.startsWith("The line names lamp-b9, which is not described; "));
    assertThat(said("sl", "(increase (level ?self) 1)")).startsWith("0", "an effect");
  }
}
