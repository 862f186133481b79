package org.maestro.console.chat;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Supplier;
import org.maestro.language.Language;
import org.maestro.language.Understanding;
import org.maestro.language.meaning.Meaning;
import org.maestro.language.reference.Discourse;
import org.maestro.language.reference.Situation;
import org.maestro.language.wording.AbilityWords;
import org.maestro.language.wording.AnswerWords;
import org.maestro.language.wording.GoalWords;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * Reads what a person says in her language, and remembers what was spoken of with her. Any thread
 * may ask.
 */
final class SpokenWords {
  private static final String ENGLISH = "en";
  private static final String LOCATION = "Location";
  private static final int MINUTES_OF_HOUR = 60;

  private final Supplier<Home> home;
  private final Supplier<? extends Facts> facts;
  private final Supplier<Instant> now;
  private Optional<Spoken> spoken = Optional.empty();
  private Discourse discourse = Discourse.NONE;

  /** The language of a home as it was. */
  private record Spoken(Home home, Language language) {}

  /**
   * The words of a home.
   *
   * @param home as it is known at the time
   * @param facts what is known at the time
   * @param now the time that clocks on the walls show
   */
  SpokenWords(Supplier<Home> home, Supplier<? extends Facts> facts, Supplier<Instant> now) {
    this.home = home;
    this.facts = facts;
    this.now = now;
  }

  /**
   * What words were heard to be.
   *
   * @param reading what is meant, or what is to be asked back; empty when it is not understood
   * @param reply what is to be said when nobody else understands it
   * @param answering whether something was asked back before
   */
  record Hearing(Optional<Reading> reading, Optional<String> reply, boolean answering) {
    /** Nothing was heard. */
    static final Hearing NOTHING = new Hearing(Optional.empty(), Optional.empty(), false);
  }

  /** What is meant. */
  synchronized Hearing read(Utterance utterance) {
    Home there = home.get();
    boolean isAsked = discourse.asked().isPresent();
    Understanding understood =
        language(there).understand(utterance.text(), situation(there, utterance));
    Optional<Reading> reading =
        understood
            .message()
            .flatMap(message -> MessageReading.of(message, there))
            .or(() -> understood.question().map(text -> new Reading.Back(text, List.of())))
            .or(() -> social(understood))
            .or(() -> agreed(understood));
    if (reading.isPresent()) {
      discourse = understood.discourse(discourse);
    }
    return new Hearing(reading, understood.reply(), isAsked);
  }

  /** A yes or no that answers nothing of which the language knows. */
  private static Optional<Reading> agreed(Understanding understood) {
    return understood.meanings().stream()
        .findFirst()
        .map(Meaning::form)
        .filter(form -> form.is("no") || form.is("yes") && form.parts().isEmpty())
        .map(form -> new Reading.Agreed(form.is("yes"), understood.reply().orElse("")));
  }

  /** The words in which she is told of goals. */
  synchronized GoalWords goals(String person) {
    Home there = home.get();
    return new GoalWords(there, language(there).grammar(), Optional.of(person));
  }

  /**
   * What can be done.
   *
   * @param present the members that can be used
   */
  synchronized String able(Utterance utterance, Collection<String> present, Optional<Term> place) {
    Home there = home.get();
    return new AbilityWords(situation(there, utterance), language(there).grammar())
        .of(present, place);
  }

  /** A greeting is answered, and nothing else comes of it. */
  private static Optional<Reading> social(Understanding understood) {
    return understood.meanings().stream()
        .findFirst()
        .filter(best -> best.kind().equals("social"))
        .flatMap(best -> understood.reply())
        .map(Reading.Said::new);
  }

  /** What is known of a question that was understood, as people say it. */
  synchronized String answer(JsonNode document) {
    return answers().of(found(document));
  }

  /** Whether nobody knows an answer to it. */
  static boolean isUnknown(JsonNode document) {
    List<AnswerWords.Found> found = found(document);
    return found.stream().noneMatch(one -> one.truth() == Truth.TRUE)
        && (found.isEmpty() || found.stream().anyMatch(one -> one.truth() == Truth.UNKNOWN));
  }

  /**
   * For how many things it is known to be so.
   *
   * @param formula with the variable that was counted
   */
  synchronized String counted(JsonNode document, String formula) {
    return answers().counted(found(document), isKnownOfAll(formula));
  }

  /** Whether of nothing it is unknown. */
  private boolean isKnownOfAll(String text) {
    Home there = home.get();
    Formula formula = SlParser.formula(text, there.vocabulary()::isFluent);
    Set<String> variables = FreeVariables.of(formula);
    Facts now = facts.get();
    Evaluation evaluation = new Evaluation(now);
    return variables.size() == 1
        && now.individuals("").stream()
            .map(one -> Map.<String, Term>of(variables.iterator().next(), one))
            .noneMatch(binding -> evaluation.truth(formula, binding) == Truth.UNKNOWN);
  }

  private AnswerWords answers() {
    Home there = home.get();
    return new AnswerWords(there, language(there).grammar());
  }

  private static List<AnswerWords.Found> found(JsonNode document) {
    List<AnswerWords.Found> found = new ArrayList<>();
    for (JsonNode answer : document.path("answers")) {
      Map<String, String> binding = new LinkedHashMap<>();
      answer
          .path("binding")
          .properties()
          .forEach(one -> binding.put(one.getKey(), one.getValue().asText()));
      // What a device tells of itself is so until it tells otherwise.
      boolean isOld =
          answer.path("age_s").isNumber()
              && answer.path("because").path(0).path("kind").asText().equals("observed");
      found.add(
          new AnswerWords.Found(
              Truth.valueOf(answer.path("truth").asText("unknown").toUpperCase(Locale.ROOT)),
              binding,
              isOld ? OptionalDouble.of(answer.path("age_s").asDouble()) : OptionalDouble.empty()));
    }
    return found;
  }

  /** A home that changes is another one: what is in it need not be compared. */
  @SuppressWarnings("ReferenceEquality")
  private Language language(Home there) {
    Spoken known =
        spoken
            .filter(one -> one.home() == there)
            .orElseGet(() -> new Spoken(there, Language.of(there, ENGLISH)));
    spoken = Optional.of(known);
    return known.language();
  }

  private Situation situation(Home there, Utterance utterance) {
    LocalTime time =
        now.get().atZone(there.timeZone().orElseGet(ZoneId::systemDefault)).toLocalTime();
    return new Situation(
        there,
        facts.get(),
        Optional.of(utterance.person()),
        Optional.of(place(there, utterance.room())),
        Optional.empty(),
        OptionalInt.of(time.getHour() * MINUTES_OF_HOUR + time.getMinute()),
        discourse);
  }

  /** Where a room is no place of which anything is known, its zone is, which is called the same. */
  private static String place(Home there, String room) {
    Individual named = there.individuals().get(room);
    if (named == null || named.classes().contains(LOCATION)) {
      return room;
    }
    return there.individuals().values().stream()
        .filter(one -> one.classes().contains(LOCATION) && one.label().equals(named.label()))
        .map(Individual::name)
        .findFirst()
        .orElse(room);
  }
}
