package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Set;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Scripts as ADE's are printed, and what is told of those that are not (ADE, 5; A76). */
class PrintedScriptReaderTest {
  private static final String AS_PRINTED =
      """
      script: prepareRoom
      agent: livingroom
      agent: person
      name: show
      activateLights(livingroom)
      show := queryPrefs(livingroom, person, "TV show", currenttime)
      activateTV(livingroom)
      selectTVshow(livingroom, show)
      """;

  private static PrintedScript read(String text) {
    return PrintedScriptReader.read(text, Set.of("currenttime", "greet")::contains);
  }

  private static String body(String steps) {
    return SlPrinter.print(
        read("script: s\nagent: a\nname: n\nn := greet(a)\n" + steps.replace(" | ", "\n")).body());
  }

  @Test
  void theEightLinesOfThePaper() {
    PrintedScript script = read(AS_PRINTED);

    assertThat(script.name()).isEqualTo("prepareRoom");
    assertThat(script.agents()).containsExactly("livingroom", "person");
    assertThat(SlPrinter.print(script.body()))
        .isEqualTo(
            "(seq (run activateLights ?livingroom)"
                + " (let ?currenttime (run currenttime)"
                + " (let ?show (run queryPrefs ?livingroom ?person \"TV show\" ?currenttime)"
                + " (run activateTV ?livingroom)"
                + " (run selectTVshow ?livingroom ?show))))");
  }

  @Test
  void whatIsReadIsMaestroSl() {
    Body body = read(AS_PRINTED).body();

    assertThat(SlParser.body(SlPrinter.print(body), name -> false)).isEqualTo(body);
  }

  @Test
  void blankLinesAndIndentationAreNothing() {
    assertThat(read("\n" + AS_PRINTED.replace("\n", "\n\n").indent(6).replace(",", "  ,")))
        .isEqualTo(read(AS_PRINTED));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      quoteCharacter = '`',
      value = {
        "f(n) ; (let ?n (run greet ?a) (run f ?n))",
        "f() ; (let ?n (run greet ?a) (run f))",
        "n := f(n) | g(n) ; (let ?n (run greet ?a) (let ?n (run f ?n) (run g ?n)))",
        "f(lamp-1, -2.5, \"a, b\", 7) ; (let ?n (run greet ?a) (run f lamp-1 -2.5 \"a, b\" 7))",
        "f(1e, 1e3, true) ; (let ?n (run greet ?a) (run f 1e 1000 true))",
        "n := f(a) ; (let ?n (run greet ?a) (run f ?a))",
        "f(greet, currenttime) ; (let ?n (run greet ?a) (let ?currenttime (run currenttime)"
            + " (let ?greet (run greet) (run f ?greet ?currenttime))))",
      })
  void steps(String steps, String expected) {
    assertThat(body(steps)).isEqualTo(expected);
  }

  /** Any text is a script that can be written in MAESTRO-SL, or has a line that says why not. */
  @Property(tries = 500)
  void anyText(@ForAll("texts") String text) {
    try {
      Body body = read(text).body();

      assertThat(SlParser.body(SlPrinter.print(body), name -> false)).isEqualTo(body);
    } catch (PrintedScriptException e) {
      assertThat(e.line()).isBetween(1, Math.max(1, (int) text.lines().count()));
    }
  }

  @Provide
  Arbitrary<String> texts() {
    Arbitrary<String> piece =
        Arbitraries.of(
            "script: s\n",
            "agent: ",
            "name: ",
            "a",
            "n",
            "f(",
            "(",
            ")",
            ":=",
            " ",
            ",",
            "\n",
            "\"",
            "7",
            "1e999",
            "-",
            "true",
            "greet",
            "?",
            ":",
            "=",
            "agent: a\nname: n\nn := greet(a)\n");
    return piece
        .list()
        .ofMaxSize(25)
        .map(pieces -> String.join("", pieces))
        .map("script: s\n"::concat);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      quoteCharacter = '`',
      value = {
        " ; Line 1 ends without a script; begin with script: NAME.",
        "f(a) ; Line 1 is \"f(a)\" where the script's name is wanted; write script: NAME.",
        "agent: a ; Line 1 is \"agent: a\" where the script's name is wanted",
        "script: ; Line 1 has \"\" where a name is wanted; write one name there.",
        "script: two words ; Line 1 has \"two words\" where a name is wanted",
        "script: s ; Line 1 ends without a step; write a call, such as activateLights(livingroom)",
        "script: s | room: a | f(a) ; Line 2 declares the unknown kind room; write agent: NAME",
        "script: s | script: t | f(a) ; Line 2 declares the unknown kind script",
        "script: s | agent: a | name: a | f(a) ; Line 3 declares a again; keep one of both.",
        "script: s | f(b) | agent: a ; Line 3 declares a after a call; write it before the first",
        "script: s | f ; Line 2 is \"f\", which is no call; write a call, such as",
        "script: s | f(a ; Line 2 is \"f(a\", which is no call",
        "script: s | f(a) g(a) ; Line 2 has \"a) g(a\" where an argument is wanted; write a name",
        "script: s | f(g(a)) ; Line 2 has \"g(a)\" where an argument is wanted",
        "script: s | f(a,) ; Line 2 has \"\" where an argument is wanted",
        "script: s | f(,a) ; Line 2 has \",a\" where an argument is wanted",
        "script: s | f(a b) ; Line 2 has \"a b\" where an argument is wanted",
        "script: s | f(?a) ; Line 2 has \"?a\" where an argument is wanted",
        "script: s | f(1e999) ; Line 2 has \"1e999\" where an argument is wanted",
        "script: s | f(-) ; Line 2 has \"-\" where an argument is wanted",
        "script: s | ?f(a) ; Line 2 has \"?f\" where a name is wanted",
        "script: s | f(\"a) ; Line 2 has \"\"a\" where an argument is wanted",
        "script: s | n := f(a) ; Line 2 gives a value to n, which is no name of the script; declare"
            + " it above, name: n.",
        "script: s | agent: n | n := f(a) ; Line 3 gives a value to n, which is no name",
        "script: s | name: n | n := 7 ; Line 3 is \"n := 7\", which is no call",
        "script: s | name: n | f(n) ; Line 3 uses n, which has no value yet; give it one before",
        "script: s | name: n | n := f(n) ; Line 3 uses n, which has no value yet",
        "script: s | name: n | f(a) ; Line 3 ends without a value for the name n; give it one, n :="
            + " CALL, or declare it as agent: n.",
      })
  void whatIsNone(String text, String expected) {
    String lines = text == null ? "" : text.replace(" | ", "\n");
    assertThatThrownBy(() -> read(lines))
        .isInstanceOf(PrintedScriptException.class)
        .hasMessageStartingWith(expected);
  }
}
