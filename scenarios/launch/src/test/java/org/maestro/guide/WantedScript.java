package org.maestro.guide;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * One of the scripts of the page, with all that stands beside it there.
 *
 * @param turtle as in the home
 * @param command that begins it
 * @param yaml the same for Home Assistant
 */
record WantedScript(String name, String turtle, String command, String yaml) {
  static final Path PAGE = Path.of("../../docs/scripts-that-people-want.md");

  private static final Pattern NAME = Pattern.compile("home:(\\w+) a maestro:Script ");
  private static final Pattern GOAL = Pattern.compile("^\\./maestro goal '(.*)'$");
  private static final Pattern RUN = Pattern.compile("^\\./maestro run-script (\\w+)$");

  static List<WantedScript> all() {
    return Arrays.stream(page().split("\n## "))
        .filter(section -> NAME.matcher(section).find())
        .map(WantedScript::read)
        .toList();
  }

  static WantedScript named(String name) {
    return all().stream().filter(script -> script.name().equals(name)).findAny().orElseThrow();
  }

  private static WantedScript read(String section) {
    String turtle = block(section, "turtle");
    Matcher name = NAME.matcher(turtle);
    assertThat(name.find()).isTrue();
    return new WantedScript(
        name.group(1), turtle, block(section, "bash").strip(), block(section, "yaml"));
  }

  static String page() {
    try {
      return Files.readString(PAGE);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The first one in that language. */
  static String block(String text, String language) {
    Matcher block = Pattern.compile("```" + language + "\n(.*?)```", Pattern.DOTALL).matcher(text);
    assertThat(block.find()).as(language).isTrue();
    return block.group(1);
  }

  /** What the command asks for. */
  String goal() {
    Matcher goal = GOAL.matcher(command);
    if (goal.find()) {
      return goal.group(1);
    }
    Matcher run = RUN.matcher(command);
    assertThat(run.find()).as(command).isTrue();
    return "(" + run.group(1) + ")";
  }

  long lines() {
    return lines(turtle) + lines(command);
  }

  /** Those that say something. */
  static long lines(String code) {
    return code.lines().filter(line -> !line.isBlank() && !line.strip().startsWith("#")).count();
  }

  long characters() {
    return characters(turtle) + characters(command);
  }

  /** Without blanks, of which YAML needs many. */
  static long characters(String code) {
    return code.chars().filter(one -> !Character.isWhitespace(one)).count();
  }
}
