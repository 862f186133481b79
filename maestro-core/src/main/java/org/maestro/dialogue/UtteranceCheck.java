package org.maestro.dialogue;

import java.util.List;
import java.util.Optional;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.validation.Nearest;
import org.maestro.text.VisibleText;

/**
 * The check whether something can have been said at all, before anybody tries to understand it: by
 * a person of the home, in one of its rooms, in so many words as one says at once.
 */
public final class UtteranceCheck {
  private static final int MOST_CHARACTERS = 2_000;
  private static final int LONGEST_NAME = 100;
  private static final String PERSON = "Person";
  private static final String ROOM = "Room";

  private final Home home;

  /** For what is said in this home. */
  public UtteranceCheck(Home home) {
    this.home = home;
  }

  /** One sentence that says what is wrong and what to do; empty when nothing is. */
  public Optional<String> objection(Utterance utterance) {
    return tooLong(utterance.text())
        .or(() -> unknown(utterance.person(), PERSON, "person"))
        .or(() -> utterance.room().isEmpty() ? Optional.empty() : unknownRoom(utterance.room()))
        .or(() -> unreadable(utterance.text()))
        .or(() -> forAnother(utterance.person(), utterance.asker()));
  }

  /**
   * The same of something else that a person does, by whatever way.
   *
   * @param asker see {@link Utterance}
   */
  public Optional<String> objection(String person, Optional<String> asker) {
    return unknown(person, PERSON, "person").or(() -> forAnother(person, asker));
  }

  private static Optional<String> tooLong(String text) {
    return text.length() > MOST_CHARACTERS
        ? Optional.of(
            "That is longer than %d characters; say less at once.".formatted(MOST_CHARACTERS))
        : Optional.empty();
  }

  /** A person of the home who has proven who she is speaks for nobody else. */
  private Optional<String> forAnother(String person, Optional<String> asker) {
    return asker
        .filter(name -> persons().stream().anyMatch(name::equalsIgnoreCase))
        .filter(name -> !name.equalsIgnoreCase(person))
        .map(
            name ->
                "%s does not speak for %s; each person speaks for herself."
                    .formatted(name, person));
  }

  private static Optional<String> unreadable(String text) {
    return VisibleText.lines(text).equals(text)
        ? Optional.empty()
        : Optional.of(
            "There are characters in that which nobody can say, such as control characters; leave"
                + " them out.");
  }

  private Optional<String> unknownRoom(String room) {
    return unknown(room, ROOM, "room");
  }

  private Optional<String> unknown(String said, String className, String what) {
    String name = said.length() > LONGEST_NAME ? said.substring(0, LONGEST_NAME) + "..." : said;
    List<String> names = names(className);
    return names.contains(name)
        ? Optional.empty()
        : Optional.of(
            "This home has no %s %s; %s."
                .formatted(
                    what,
                    VisibleText.line(name),
                    Nearest.cure(
                        name,
                        names,
                        names.isEmpty() ? "give it one" : "it has " + String.join(", ", names))));
  }

  /** The persons of the home, by their names. */
  public List<String> persons() {
    return names(PERSON);
  }

  private List<String> names(String className) {
    return home.individuals().values().stream()
        .filter(one -> one.classes().contains(className))
        .map(Individual::name)
        .toList();
  }
}
