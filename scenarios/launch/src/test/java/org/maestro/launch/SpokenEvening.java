package org.maestro.launch;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.maestro.language.Language;
import org.maestro.language.Listening;
import org.maestro.language.Understanding;
import org.maestro.language.reference.Discourse;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Facts;

/** What is said in the evening's house at five past six. */
final class SpokenEvening {
  private static final int MINUTE_OF_DAY = 18 * 60 + 5;

  private final Facts facts;
  private final Home home = Shipped.home("evening");

  SpokenEvening() {
    this.facts = SceneFacts.of(home, Optional.of(Shipped.scene("evening", home)));
  }

  /**
   * One line.
   *
   * @param before what was said before
   */
  record Line(String words, String speaker, String room, Optional<String> before) {
    private static Line of(String line) {
      String[] columns = line.split("\t", -1);
      return new Line(
          columns[0], columns[1], columns[2], Optional.of(columns[3]).filter(b -> !b.isBlank()));
    }
  }

  Home home() {
    return home;
  }

  /** All lines of the list. */
  static List<Line> lines() {
    return text(UnderstandCommandTest.class, "evening.tsv")
        .lines()
        .filter(line -> !line.startsWith("#"))
        .map(Line::of)
        .toList();
  }

  static String text(Class<?> beside, String resource) {
    try (InputStream stream = beside.getResourceAsStream(resource)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Where a line is said, before anything was. */
  Situation situation(Home there, Line line) {
    return new Situation(
        there,
        facts,
        Optional.of(line.speaker()),
        Optional.of(line.room()),
        Optional.of("rob"),
        OptionalInt.of(MINUTE_OF_DAY),
        Discourse.NONE);
  }

  /** Words are heard one by one. */
  static Understanding understood(Language language, List<String> words, Situation situation) {
    Listening listening = language.listen(situation);
    words.forEach(listening::hear);
    return listening.end(String.join(" ", words));
  }
}
