package org.maestro.troubleshooting;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The page of messages has every message of the code, as it stands there now. */
class TroubleshootingTest {
  private static final Path ROOT = Path.of("../..").toAbsolutePath().normalize();
  private static final Path PAGE = ROOT.resolve("docs/troubleshooting.md");
  private static final Path CURRENT = Path.of("target/troubleshooting.md");

  private static final String WRITE_ANEW =
      "docs/troubleshooting.md has not the messages that the code has now; write it anew: cp"
          + " scenarios/launch/target/troubleshooting.md docs/";

  private static SortedSet<Message> messages;
  private static TroubleshootingPage page;
  private static String written;

  @BeforeAll
  static void read() throws IOException {
    messages = SourceMessages.of(ROOT);
    messages.addAll(OtherMessages.of(ROOT));
    page = new TroubleshootingPage(Kinds.of(ROOT), messages);
    written = Files.readString(PAGE);
  }

  @Test
  void isCurrent() throws IOException {
    String current = page.current(written);
    Files.writeString(CURRENT, current);

    assertThat(linesOf(current, written)).as("%s; missing lines", WRITE_ANEW).isEmpty();
    assertThat(linesOf(written, current)).as("%s; lines too many", WRITE_ANEW).isEmpty();
    assertThat(written.equals(current)).as(WRITE_ANEW).isTrue();
  }

  private static List<String> linesOf(String page, String other) {
    Set<String> there = other.lines().collect(Collectors.toSet());
    return page.lines().filter(line -> !there.contains(line)).toList();
  }

  @Test
  void hasAPlaceForEveryMessage() {
    assertThat(page.homeless(written))
        .as(
            "classes whose messages have no place in docs/troubleshooting.md; name them, or their"
                + " package, where the page says what their messages mean")
        .isEmpty();
  }

  /** Messages that people have got, of each way in which the code makes them. */
  @Test
  void findsMessagesHoweverTheyAreMade() {
    assertThat(messages)
        .extracting(Message::text)
        .contains(
            "No platform runs; start one with ./maestro run bob",
            "The directory … is in use by another platform…; stop it, or name another directory.",
            "is no known class; …",
            "The journal in … can be written again.",
            "The queue of … is full; try later",
            "The goal is not taken on, because the journal in … cannot be written: …. See to it, and state the goal again.",
            "There is no Java here; install a JDK 17 or newer, or set JAVA_HOME to one.")
        .hasSizeGreaterThan(900);
  }

  /** Each kind of mistake that {@code check} is known to tell is found here by who got it. */
  @ParameterizedTest
  @ValueSource(strings = {"homes", "scenes", "descriptions"})
  void findsEveryKnownMistake(String file) throws IOException {
    List<String> told =
        Files.readAllLines(Path.of("src/test/resources/mistakes", file + ".txt")).stream()
            .filter(line -> line.startsWith("fault ") || line.startsWith("warning "))
            .toList();

    assertThat(told)
        .hasSizeGreaterThan(10)
        .allMatch(line -> messages.stream().anyMatch(message -> message.isIn(line)));
  }
}
