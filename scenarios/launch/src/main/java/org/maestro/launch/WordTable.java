package org.maestro.launch;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.maestro.language.Language;
import org.maestro.language.Listening;
import org.maestro.language.Understanding;
import org.maestro.language.meaning.Meaning;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.wording.Construction;
import org.maestro.sl.SlPrinter;

/**
 * What each word changes: for each reading that is under way what may fill its roles, a question
 * mark where something is still to be said, and what could be done meanwhile (A61, A63, A66).
 */
final class WordTable {
  static final List<String> COLUMNS = List.of("word", "reading", "may be", "meanwhile");

  private static final int MOST_NAMED = 6;

  private final Situation situation;
  private final Listening listening;
  private final Set<String> lookedAt = new LinkedHashSet<>();
  private List<Understanding.Begun> begun = List.of();
  private boolean nods;

  WordTable(Language language, Situation situation) {
    this.situation = situation;
    this.listening = language.listen(situation);
  }

  /** The lines of the next word. */
  List<List<String>> hear(String word) {
    listening.hear(word);
    Set<List<String>> readings = new LinkedHashSet<>();
    listening.underWay().forEach(one -> readings.add(List.of(one.construction(), roles(one))));
    if (readings.isEmpty()) {
      readings.add(List.of("", ""));
    }
    List<List<String>> rows = new ArrayList<>();
    String shown = word;
    String meanwhile = meanwhile();
    for (List<String> reading : readings) {
      rows.add(List.of(shown, reading.get(0), reading.get(1), meanwhile));
      shown = "";
      meanwhile = "";
    }
    return rows;
  }

  private String roles(Understanding.UnderWay reading) {
    return situation.home().wording().constructions().stream()
        .filter(one -> one.name().equals(reading.construction()))
        .flatMap(one -> one.roles().stream())
        .filter(role -> !candidates(reading, role).isEmpty() || isOpen(reading, role))
        .map(role -> role.name() + ": " + shown(candidates(reading, role)))
        .collect(Collectors.joining("; "));
  }

  private static List<String> candidates(Understanding.UnderWay reading, Construction.Role role) {
    return reading.roles().getOrDefault(role.name(), List.of());
  }

  private static boolean isOpen(Understanding.UnderWay reading, Construction.Role role) {
    return !role.optional() && !reading.said().contains(role.name());
  }

  private static String shown(List<String> things) {
    return things.isEmpty()
        ? "?"
        : things.size() > MOST_NAMED ? Integer.toString(things.size()) : String.join(", ", things);
  }

  private String meanwhile() {
    List<String> news = new ArrayList<>();
    List<Understanding.Begun> now = listening.began();
    for (int i = 0; i < now.size(); i++) {
      boolean isNew = i >= begun.size();
      if (isNew) {
        news.add("begins " + goal(now.get(i)));
      } else if (now.get(i).calledOff().isPresent() && begun.get(i).calledOff().isEmpty()) {
        news.add("calls off " + goal(now.get(i)));
      }
    }
    begun = now;
    listening.attention().stream()
        .filter(lookedAt::add)
        .forEach(thing -> news.add("looks at " + thing));
    boolean isComplete = listening.isComplete();
    if (isComplete && !nods) {
      news.add("nods");
    }
    nods = isComplete;
    return String.join("; ", news);
  }

  private static String goal(Understanding.Begun begun) {
    return Meaning.goal(begun.message())
        .map(SlPrinter::print)
        .orElseGet(() -> SlPrinter.print(begun.message()));
  }
}
