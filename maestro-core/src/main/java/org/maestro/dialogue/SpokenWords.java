package org.maestro.dialogue;

import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.maestro.language.Language;
import org.maestro.language.Listening;
import org.maestro.language.Understanding;
import org.maestro.language.meaning.Doubt;
import org.maestro.language.meaning.Meaning;
import org.maestro.language.meaning.SaidAnswer;
import org.maestro.language.reference.Discourse;
import org.maestro.language.reference.Situation;
import org.maestro.language.wording.AbilityWords;
import org.maestro.language.wording.AnswerWords;
import org.maestro.language.wording.GoalWords;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sl.Content;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * Reads what a person says in her language, and remembers what was spoken of with her. Any thread
 * may ask.
 */
public final class SpokenWords {
  private static final String LOCATION = "Location";
  private static final int MINUTES_OF_HOUR = 60;

  private final Supplier<Home> home;
  private final Supplier<? extends Facts> facts;
  private final Supplier<Instant> now;
  private final Consumer<Utterance> listener;
  private Optional<Spoken> spoken = Optional.empty();
  private Discourse discourse = Discourse.NONE;
  private Optional<Utterance> latest = Optional.empty();
  private Optional<String> room = Optional.empty();

  /** The language of a home as it was, and as those of its room agents have it who were asked. */
  private record Spoken(
      Home home, String tag, Language language, Map<String, Language> languageByListener) {
    Language of(Utterance said) {
      return said.listener()
          .flatMap(name -> Optional.ofNullable(home.groups().get(name)))
          .flatMap(Group::hearing)
          .map(
              hearing ->
                  languageByListener.computeIfAbsent(
                      said.listener().orElseThrow(), name -> language.about(hearing.topics())))
          .orElse(language);
    }
  }

  /**
   * What somebody makes of an utterance before it is said that it is for him.
   *
   * @param isUnderstood whether all of it is, or something is to be asked back
   * @param coverage the share of its words that had a place, 0 to 1
   * @param mentioned names of what it speaks of
   * @param reply what he would say of what he does not understand
   */
  public record Grasp(
      boolean isUnderstood, double coverage, Set<String> mentioned, Optional<String> reply) {
    public Grasp {
      mentioned = Set.copyOf(mentioned);
    }
  }

  /**
   * The words of a home.
   *
   * @param home as it is known at the time
   * @param facts what is known at the time
   * @param now the time that clocks on the walls show
   * @param listener is told of what is said to the end
   */
  SpokenWords(
      Supplier<Home> home,
      Supplier<? extends Facts> facts,
      Supplier<Instant> now,
      Consumer<Utterance> listener) {
    this.home = home;
    this.facts = facts;
    this.now = now;
    this.listener = listener;
  }

  /**
   * What words were heard to be.
   *
   * @param reading what is meant, or what is to be asked back; empty when it is not understood
   * @param message that it means, in MAESTRO-SL
   * @param reply what is to be said when nobody else understands it
   * @param answering whether something was asked back before
   * @param begun goals that may have been begun before the end, and belong to what is meant
   */
  public record Hearing(
      Optional<Reading> reading,
      Optional<Content> message,
      Optional<String> reply,
      boolean answering,
      List<Reading.Goals> begun) {
    /** Nothing was heard. */
    public static final Hearing NONE =
        new Hearing(Optional.empty(), Optional.empty(), Optional.empty(), false, List.of());

    public Hearing {
      begun = List.copyOf(begun);
    }
  }

  /**
   * What can be told of words after which others are to come. Nothing is remembered of them: the
   * next ones may take them back.
   */
  public synchronized Overheard overhear(Utterance words) {
    Home there = home.get();
    room = room(words);
    Language language = language(there, Optional.of(words));
    Listening listening = language.hear(words.text(), situation(there, words));
    return new Overheard(
        begun(listening.began(), reading(there, language)),
        listening.attention(),
        listening.isComplete());
  }

  private static MessageReading reading(Home there, Language language) {
    return new MessageReading(there, language.grammar());
  }

  /** Of what was not called off. */
  private static List<Reading.Goals> begun(
      List<Understanding.Begun> began, MessageReading reading) {
    return began.stream()
        .filter(one -> one.calledOff().isEmpty())
        .flatMap(one -> reading.of(one.message()).stream())
        .filter(Reading.Goals.class::isInstance)
        .map(Reading.Goals.class::cast)
        .toList();
  }

  /** Who does not say where she is has gone nowhere. */
  private Optional<String> room(Utterance utterance) {
    return Optional.of(utterance.room()).filter(said -> !said.isEmpty()).or(() -> room);
  }

  /** What is meant. */
  public synchronized Hearing read(Utterance utterance) {
    listener.accept(utterance);
    Home there = home.get();
    boolean isAsked = discourse.asked().isPresent();
    latest = Optional.of(utterance);
    room = room(utterance);
    Language language = language(there);
    Situation situation = situation(there, utterance);
    Understanding understood = language.understand(utterance.text(), situation);
    Optional<Reading> reading = reading(understood, language, situation);
    if (reading.isPresent()) {
      discourse = understood.discourse(discourse);
    }
    return new Hearing(
        reading,
        understood.message(),
        understood.reply(),
        isAsked,
        begun(understood.began(), reading(there, language)));
  }

  private static Optional<Reading> reading(
      Understanding understood, Language language, Situation situation) {
    // What she may not have done need not be confirmed.
    boolean isRefused = language.refusal(understood, situation).isPresent();
    return (isRefused ? understood.wish() : understood.message())
        .flatMap(reading(situation.home(), language)::of)
        .or(() -> understood.question().map(text -> new Reading.Back(text, List.of())))
        .or(() -> social(understood))
        .or(() -> agreed(understood));
  }

  /** What would become of an utterance, of which nothing is remembered but where she is. */
  public synchronized Grasp grasp(Utterance heard) {
    Home there = home.get();
    room = room(heard);
    Situation situation = situation(there, heard);
    Language language = language(there, Optional.of(heard));
    Understanding understood = language.understand(heard.text(), situation);
    boolean isUnderstood =
        understood.unknown().isEmpty()
            && !isForOthers(understood)
            && reading(understood, language, situation).isPresent();
    Set<String> mentioned =
        understood.meanings().stream()
            .limit(1)
            .flatMap(meaning -> meaning.mentioned().stream())
            .map(Term.Name::text)
            .collect(Collectors.toSet());
    return new Grasp(isUnderstood, understood.coverage(), mentioned, understood.reply());
  }

  /** Whether who knows other words may make something of it. */
  private static boolean isForOthers(Understanding understood) {
    return understood.meanings().stream()
        .findFirst()
        .flatMap(Meaning::doubt)
        .filter(
            doubt ->
                doubt instanceof Doubt.NoSuch
                    || doubt instanceof Doubt.LeftOut
                    || doubt instanceof Doubt.Nothing)
        .isPresent();
  }

  /**
   * What she says, as the answer to a question of a script, in the words in which scripts take
   * answers; empty where it says nothing of what is wanted. Nothing is remembered of it.
   *
   * @param type of answer that is wanted, as the script has it
   */
  public synchronized Optional<String> answer(Utterance utterance, String type) {
    Home there = home.get();
    room = room(utterance);
    Situation situation = situation(there, utterance, Discourse.NONE);
    return new SaidAnswer(type, situation)
        .of(
            language(there, Optional.of(utterance))
                .understand(utterance.text(), situation)
                .meanings());
  }

  /**
   * Whether something would be understood that she could have said instead, as a wish or a
   * question. Nothing is remembered of it.
   */
  public synchronized boolean isUnderstood(Utterance instead) {
    Home there = home.get();
    Language language = language(there, Optional.of(instead));
    Understanding understood = language.understand(instead.text(), situation(there, instead));
    return understood.unknown().isEmpty()
        && understood.wish().flatMap(reading(there, language)::of).isPresent();
  }

  /** What can be said in her language, for who does not know the home. */
  public synchronized Sayable sayable(Utterance utterance) {
    Home there = home.get();
    return Sayable.of(there, language(there, Optional.of(utterance)).grammar().language());
  }

  /**
   * What she is told when she may not have a goal pursued; empty when she may.
   *
   * @param goal in MAESTRO-SL
   */
  public synchronized Optional<String> refusal(String goal, Utterance utterance) {
    Home there = home.get();
    try {
      Formula formula = SlParser.formula(goal, there.vocabulary()::isFluent);
      return language(there, Optional.of(utterance)).refusal(formula, situation(there, utterance));
    } catch (SlSyntaxException e) {
      // Who takes it on tells what is wrong with it.
      return Optional.empty();
    }
  }

  /** A yes or no that answers nothing of which the language knows. */
  private static Optional<Reading> agreed(Understanding understood) {
    return understood.meanings().stream()
        .findFirst()
        .map(Meaning::form)
        .filter(form -> form.is("no") || form.is("yes") && form.parts().isEmpty())
        .map(form -> new Reading.Agreed(form.is("yes"), understood.reply().orElse("")));
  }

  /** The words in which she is told of goals who says that. */
  public synchronized GoalWords goals(Utterance utterance) {
    Home there = home.get();
    return new GoalWords(
        there, language(there, Optional.of(utterance)).grammar(), Optional.of(utterance.person()));
  }

  /**
   * What can be done.
   *
   * @param present the members that can be used
   */
  public synchronized String able(
      Utterance utterance, Collection<String> present, Optional<Term> place) {
    Home there = home.get();
    return new AbilityWords(
            situation(there, utterance), language(there, Optional.of(utterance)).grammar())
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

  /**
   * Words with which what she is just writing could go on.
   *
   * @param most so many at most
   */
  public synchronized List<String> next(Utterance begun, int most) {
    Home there = home.get();
    return language(there).next(begun.text(), situation(there, begun), most);
  }

  /**
   * What is known of a question that was understood, as people say it.
   *
   * @param asked the formula
   */
  public synchronized String answer(List<AnswerWords.Found> answers, String asked) {
    return answers().of(answers, fluent(asked));
  }

  private Optional<String> fluent(String asked) {
    return SlParser.formula(asked, home.get().vocabulary()::isFluent)
                instanceof Formula.Comparison comparison
            && comparison.left() instanceof Expression.Fluent fluent
        ? Optional.of(fluent.name())
        : Optional.empty();
  }

  /**
   * For how many things it is known to be so.
   *
   * @param formula with the variable that was counted
   */
  public synchronized String counted(List<AnswerWords.Found> answers, String formula) {
    return answers().counted(answers, isKnownOfAll(formula));
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

  private Language language(Home there) {
    return language(there, latest);
  }

  /** A home that changes is another one: what is in it need not be compared. */
  @SuppressWarnings("ReferenceEquality")
  private Language language(Home there, Optional<Utterance> said) {
    String tag =
        said.flatMap(Utterance::language)
            .orElseGet(() -> Language.spoken(there, said.map(Utterance::person)));
    Spoken known =
        spoken
            .filter(one -> one.home() == there && one.tag().equals(tag))
            .orElseGet(
                () -> new Spoken(there, tag, Language.of(there, tag), new ConcurrentHashMap<>()));
    spoken = Optional.of(known);
    return said.map(known::of).orElse(known.language());
  }

  private Situation situation(Home there, Utterance utterance) {
    return situation(there, utterance, discourse);
  }

  private Situation situation(Home there, Utterance utterance, Discourse before) {
    LocalTime time =
        now.get().atZone(there.timeZone().orElseGet(ZoneId::systemDefault)).toLocalTime();
    return new Situation(
        there,
        facts.get(),
        Optional.of(utterance.person()),
        room.map(name -> place(there, name)),
        Optional.empty(),
        OptionalInt.of(time.getHour() * MINUTES_OF_HOUR + time.getMinute()),
        before);
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
