package org.maestro.language.meaning;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.language.chart.Reading;
import org.maestro.language.grammar.Form;
import org.maestro.language.reference.NounPhrases;
import org.maestro.language.reference.Situation;
import org.maestro.sl.Content;

/**
 * Interprets readings in a situation, the best first. What was looked up for one is remembered for
 * the others. Not safe for threads.
 */
public final class Interpreter {
  /** So many readings are interpreted at most. */
  private static final int READINGS = 48;

  private final Situation situation;
  private final Set<String> idle;
  private final NounPhrases phrases;
  private final Settables settables;
  private final Confirmed confirmed;

  /** By room, what is said to it is interpreted so. */
  private final Map<String, Interpreter> rooms = new HashMap<>();

  /**
   * In a situation.
   *
   * @param idle words for states of what is not in use, such as off: it is not meant unless named
   */
  public Interpreter(Situation situation, Set<String> idle) {
    this.situation = situation;
    this.idle = Set.copyOf(idle);
    this.phrases = new NounPhrases(situation);
    this.settables = new Settables(situation.home());
    this.confirmed = new Confirmed(situation);
  }

  /**
   * What the readings mean: first those whose references hold, of these the usual wordings. Those
   * that cannot be meant at all are left out.
   */
  public List<Meaning> of(List<Reading> readings) {
    List<Meaning> meanings = new ArrayList<>();
    Answers answers = new Answers(situation.discourse());
    Map<Form, List<Reading>> toRooms = new LinkedHashMap<>();
    for (Reading reading : readings.subList(0, Math.min(READINGS, readings.size()))) {
      if (reading.form().is("spokento")) {
        toRooms
            .computeIfAbsent(reading.form().part(0), room -> new ArrayList<>())
            .add(new Reading(reading.form().part(1), reading.penalty()));
        continue;
      }
      List<Form> wholes = answers.of(reading.form()).toList();
      boolean isConfirmed = reading.form().is("yes");
      for (Form whole : wholes) {
        meaning(new Reading(whole, reading.penalty()), isConfirmed).ifPresent(meanings::add);
      }
      if (wholes.isEmpty()) {
        meaning(reading, false).ifPresent(meanings::add);
      }
    }
    toRooms.forEach(
        (room, said) ->
            inRoom(room).stream()
                .flatMap(there -> there.of(said).stream())
                .map(meant -> meant.of(Form.of("spokento", room, meant.form())))
                .forEach(meanings::add));
    meanings.sort(Comparator.comparingInt(Meaning::broken).thenComparingInt(Meaning::penalty));
    Everything.together(meanings)
        .flatMap(all -> meaning(new Reading(all, meanings.get(0).penalty()), false))
        .ifPresent(
            all -> {
              meanings.removeIf(one -> Everything.isSaidIn(one.form()));
              meanings.add(0, all);
            });
    return meanings;
  }

  /**
   * What a reading means.
   *
   * @param isAsked whether what is always asked back was asked already
   */
  private Optional<Meaning> meaning(Reading reading, boolean isAsked) {
    Form form = reading.form();
    if (form.is("spokento")) {
      return inRoom(form.part(0))
          .flatMap(there -> there.meaning(new Reading(form.part(1), reading.penalty()), isAsked))
          .map(meant -> meant.of(form));
    }
    Acts acts = Acts.in(situation, phrases.afresh(), settables, idle);
    Optional<Content> message = isBare(form) ? Optional.empty() : acts.message(form);
    References references = acts.references();
    if (references.isDead()
        || message.isEmpty() && references.doubts().isEmpty() && !isBare(form)) {
      return Optional.empty();
    }
    Optional<Doubt> doubt = references.doubts().stream().findFirst();
    return Optional.of(
        new Meaning(
            form,
            doubt.isPresent() ? Optional.empty() : message,
            doubt.or(() -> isAsked ? Optional.empty() : confirmation(form, message)),
            kind(form),
            references.broken() + references.phrases().supposed(),
            reading.penalty(),
            !isAsked && isEarly(form, acts),
            references.phrases().mentioned(),
            references.phrases().kinds(),
            references.phrases().group()));
  }

  /** What is said to a room means what it would mean if it were said there. */
  private Optional<Interpreter> inRoom(Form room) {
    return room.parts().size() == 1
        ? Optional.of(
            rooms.computeIfAbsent(
                room.text(0), name -> new Interpreter(situation.saidIn(name), idle)))
        : Optional.empty();
  }

  /** What says nothing by itself: an answer, a greeting. */
  private static boolean isBare(Form form) {
    return switch (form.head()) {
      case "answer", "also", "greet", "thank", "no" -> true;
      case "yes" -> form.parts().isEmpty() || form.part(0).is("np") || form.part(0).is("span");
      default -> false;
    };
  }

  private static String kind(Form form) {
    return switch (form.head()) {
      case "do", "wish", "instead", "refrain", "again" -> "command";
      case "whenever", "act-whenever", "if", "act-if", "timed", "act-timed" -> "rule";
      case "tell" -> "statement";
      case "answer", "also", "yes", "no" -> "answer";
      case "nevermind", "cancel", "undo" -> "cancel";
      case "greet", "thank" -> "social";
      default -> "question";
    };
  }

  private Optional<Doubt> confirmation(Form form, Optional<Content> message) {
    boolean isOfEverything = kind(form).equals("command") && Everything.isSaidIn(form);
    boolean isCalledOff = form.is("refrain");
    return !isCalledOff && (isOfEverything || message.filter(confirmed::isNeededBy).isPresent())
        ? Optional.of(new Doubt.Confirm())
        : Optional.empty();
  }

  private static boolean isEarly(Form form, Acts acts) {
    return Frames.within(form)
        .map(frame -> acts.frames().construction(frame).early())
        .orElse(form.is("do") && !form.part(0).is("run"));
  }
}
