package org.maestro.console.chat;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.maestro.agents.content.AgentNames;
import org.maestro.console.questions.AclQuestions;
import org.maestro.console.questions.FormerState;
import org.maestro.dialogue.Paraphraser;
import org.maestro.dialogue.Reading;
import org.maestro.dialogue.SpokenWords;
import org.maestro.dialogue.Utterance;
import org.maestro.language.wording.AnswerWords;
import org.maestro.language.wording.GoalWords;
import org.maestro.language.wording.Wish;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Truth;

/**
 * The home itself as an interlocutor: understands what people say in their language, and reads
 * goals and questions as they are written, too; states the goals, tells how they fare, in words
 * where they were said in words, and answers what is asked about them.
 */
public final class HomeInterlocutor implements Interlocutor {
  private final Surroundings around;
  private final AclQuestions questions;
  private final SpokenWords spoken;
  private final StatedGoals stated;
  private final WrittenTalk written;
  private final SpokenGoals goals;
  private final Paraphraser paraphraser;

  /** What was asked back about goals; guarded by this. */
  private Optional<Open> open = Optional.empty();

  /** A question of its own that is open. */
  private sealed interface Open {
    /** Whether to find something out, by that goal. */
    record Look(String goal) implements Open {}

    /** Whether this is meant, which was not said. */
    record Instead(String text) implements Open {}

    /** Which goal is to be called off. */
    record Which(List<KnownGoal> goals) implements Open {}
  }

  /**
   * @param spoken the conversation with the person who is answered
   * @param stories of all goals
   * @param stated what was asked for, by whoever
   * @param paraphraser who is asked what was meant where nobody here understands it
   */
  HomeInterlocutor(
      Surroundings around,
      SpokenWords spoken,
      AclQuestions questions,
      GoalStories stories,
      StatedGoals stated,
      Paraphraser paraphraser) {
    this.around = around;
    this.spoken = spoken;
    this.questions = questions;
    this.stated = stated;
    this.written = new WrittenTalk(around, spoken, questions, stories, stated);
    this.goals = new SpokenGoals(around, spoken, questions, stories, stated);
    this.paraphraser = paraphraser;
  }

  /**
   * Who answers each person of a home, by her name; all know what was asked for by whom.
   *
   * @param conversations the one with each person
   * @param paraphraser who is asked what was meant where nobody here understands it
   */
  public static Function<String, Interlocutor> of(
      Surroundings around,
      AclQuestions questions,
      GoalStories stories,
      Function<String, SpokenWords> conversations,
      Paraphraser paraphraser) {
    StatedGoals stated = new StatedGoals();
    return person ->
        new HomeInterlocutor(
            around, conversations.apply(person), questions, stories, stated, paraphraser);
  }

  /**
   * Where the room has an agent that listens, it is understood with the words of that; what these
   * do not say, with those of the room that understands it, which answers then.
   */
  @Override
  public void hear(Utterance utterance, Consumer<ChatEvent> listener) {
    Optional<String> agent =
        around
            .home()
            .get()
            .listener(utterance.room())
            .map(Group::id)
            .filter(its -> isSpoken(utterance));
    if (agent.isEmpty()) {
      answer(utterance, seen(utterance, listener));
      return;
    }
    Utterance heard = utterance.heardBy(agent.get());
    if (isNaming() || spoken.grasp(heard).isUnderstood()) {
      answer(heard, voice(heard, listener));
      return;
    }
    questions
        .whoUnderstands(heard)
        .thenAccept(who -> passOn(heard, who, listener))
        .exceptionally(
            nobody -> {
              answer(heard, voice(heard, listener));
              return null;
            });
  }

  /** In that of the room's agent that hears it. */
  private Consumer<ChatEvent> voice(Utterance heard, Consumer<ChatEvent> listener) {
    return seen(
        heard,
        Voice.of(Voice.persona(around.home().get(), heard.listener().orElseThrow()), listener));
  }

  /** A face says it without who speaks before it, as that is seen. */
  private Consumer<ChatEvent> seen(Utterance heard, Consumer<ChatEvent> listener) {
    return event -> {
      around.seen().accept(heard, event);
      listener.accept(event);
    };
  }

  /** Who hears several voices is told who answers, and what asking has taken. */
  private void passOn(
      Utterance heard, AclQuestions.Understander who, Consumer<ChatEvent> listener) {
    Home home = around.home().get();
    String first = heard.listener().orElseThrow();
    Optional<String> other = Voice.persona(home, who.agent());
    if (other.isPresent() && !other.equals(Voice.persona(home, first))) {
      voice(heard, listener)
          .accept(
              new ChatEvent.Told(
                  "", spoken.goals(heard).passedOn(other.get(), who.laterSeconds())));
    }
    Utterance understood = heard.heardBy(who.agent());
    answer(understood, voice(understood, listener));
  }

  /** Whether it may say which of several goals is to be called off. */
  private synchronized boolean isNaming() {
    return open.filter(Open.Which.class::isInstance).isPresent();
  }

  private void answer(Utterance utterance, Consumer<ChatEvent> listener) {
    GoalWords words = spoken.goals(utterance);
    Optional<Open> asked = closed();
    if (asked.isPresent() && asked.get() instanceof Open.Which which) {
      List<KnownGoal> named = CallingOff.named(which.goals(), utterance.text(), words);
      if (!named.isEmpty()) {
        callOff(named, utterance, words, listener);
        return;
      }
    }
    SpokenWords.Hearing heard = inWords(utterance);
    Reading reading =
        heard.reading().orElseGet(() -> withReply(written.read(utterance), heard.reply()));
    if (reading instanceof Reading.Agreed agreed) {
      agree(agreed, asked, utterance, words, listener);
    } else if (reading instanceof Reading.CalledOff off) {
      if (off.formula().isEmpty() && (asked.isPresent() || heard.answering())) {
        listener.accept(new ChatEvent.Told("", words.phrase("no")));
      } else {
        callOff(off, utterance, words, listener);
      }
    } else if (reading instanceof Reading.Unclear unclear && isSpoken(utterance)) {
      askAnother(unclear, utterance, words, listener);
    } else {
      respond(reading, utterance, words, listener);
    }
  }

  /** What nobody here understands somebody else may: then it is asked whether that is meant. */
  private void askAnother(
      Reading.Unclear unclear, Utterance utterance, GoalWords words, Consumer<ChatEvent> listener) {
    paraphraser
        .proposals(utterance.text(), spoken.sayable(utterance))
        .exceptionally(failure -> List.of())
        .thenAccept(
            proposals ->
                proposals.stream()
                    .filter(text -> isUnderstood(utterance.saying(text)))
                    .findFirst()
                    .ifPresentOrElse(
                        text -> {
                          ask(new Open.Instead(text));
                          listener.accept(new ChatEvent.Asked(words.meaning(text), List.of()));
                        },
                        () -> respond(unclear, utterance, words, listener)))
        .exceptionally(failure -> refused(failure, words, listener));
  }

  private boolean isUnderstood(Utterance instead) {
    return isSpoken(instead)
        ? spoken.isUnderstood(instead)
        : written.read(instead) instanceof Reading.Goal;
  }

  /** The question that was open; it is open no more. */
  private synchronized Optional<Open> closed() {
    Optional<Open> was = open;
    open = Optional.empty();
    return was;
  }

  private synchronized void ask(Open question) {
    open = Optional.of(question);
  }

  private void respond(
      Reading reading, Utterance utterance, GoalWords words, Consumer<ChatEvent> listener) {
    if (reading instanceof Reading.Goals several) {
      goals.state(several.formulas(), utterance, words, listener);
    } else if (reading instanceof Reading.Again) {
      again(utterance, words, listener);
    } else if (reading instanceof Reading.Undone) {
      undo(utterance, words, listener);
    } else if (reading instanceof Reading.About about) {
      tell(answers(utterance).of(about, utterance.person(), words), words, listener);
    } else if (reading instanceof Reading.Able able) {
      listener.accept(
          new ChatEvent.Told("", spoken.able(utterance, around.present().get(), able.place())));
    } else if (reading instanceof Reading.Said said) {
      listener.accept(new ChatEvent.Told("", said.text()));
    } else if (reading instanceof Reading.Back back) {
      listener.accept(new ChatEvent.Asked(back.text(), back.choices()));
    } else if (reading instanceof Reading.Counted counted) {
      answer(
          questions.know(counted.formula(), reader(utterance)),
          known ->
              new ChatEvent.Told("", spoken.counted(FoundAnswers.of(known), counted.formula())),
          words,
          listener);
    } else if (reading instanceof Reading.Asked question) {
      answer(
          likely(question.formula(), reader(utterance)),
          known -> answered(question.formula(), known, words),
          words,
          listener);
    } else {
      written.respond(reading, utterance, listener);
    }
  }

  private void agree(
      Reading.Agreed agreed,
      Optional<Open> asked,
      Utterance utterance,
      GoalWords words,
      Consumer<ChatEvent> listener) {
    if (agreed.yes() && asked.isPresent() && asked.get() instanceof Open.Look look) {
      goals.state(List.of(look.goal()), utterance, words, listener);
    } else if (agreed.yes() && asked.isPresent() && asked.get() instanceof Open.Instead instead) {
      answer(utterance.saying(instead.text()), listener);
    } else if (agreed.yes()
        && asked.isPresent()
        && asked.get() instanceof Open.Which which
        && which.goals().size() == 1) {
      callOff(which.goals(), utterance, words, listener);
    } else if (agreed.yes()) {
      asked.ifPresent(this::ask);
      listener.accept(new ChatEvent.Misunderstood(agreed.reply(), List.of()));
    } else {
      listener.accept(new ChatEvent.Told("", agreed.reply()));
    }
  }

  private void callOff(
      Reading.CalledOff off, Utterance utterance, GoalWords words, Consumer<ChatEvent> listener) {
    String person = utterance.person();
    answers(utterance)
        .goals()
        .thenAccept(
            all -> {
              CallingOff which =
                  off.formula()
                      .map(formula -> CallingOff.of(all, person, formula))
                      .orElseGet(() -> CallingOff.last(all, person, stated.lastOf(person)));
              if (!which.meant().isEmpty()) {
                callOff(which.meant(), utterance, words, listener);
              } else if (which.possible().isEmpty()) {
                listener.accept(new ChatEvent.Told("", words.phrase("call-off-nothing")));
              } else {
                ask(new Open.Which(which.possible()));
                List<Wish> wishes = which.possible().stream().map(KnownGoal::wish).toList();
                listener.accept(new ChatEvent.Asked(words.which(wishes), words.choices(wishes)));
              }
            })
        .exceptionally(failure -> refused(failure, words, listener));
  }

  private void callOff(
      List<KnownGoal> which, Utterance utterance, GoalWords words, Consumer<ChatEvent> listener) {
    CompletableFuture.allOf(
            which.stream()
                .map(goal -> questions.cancel(goal.id(), utterance.asker()))
                .toArray(CompletableFuture[]::new))
        .thenAccept(done -> listener.accept(new ChatEvent.Told("", words.phrase("no"))))
        .exceptionally(failure -> refused(failure, words, listener));
  }

  /** What she has asked for last is stated once more. */
  private void again(Utterance utterance, GoalWords words, Consumer<ChatEvent> listener) {
    List<String> last = stated.lastOf(utterance.person());
    questions
        .of(reader(utterance))
        .goals()
        .thenAccept(
            document -> {
              List<String> formulas = new ArrayList<>();
              document
                  .path("goals")
                  .forEach(
                      row -> {
                        if (last.contains(row.path("id").asText())) {
                          formulas.add(row.path("goal").asText());
                        }
                      });
              if (formulas.isEmpty()) {
                listener.accept(new ChatEvent.Told("", words.phrase("again-nothing")));
              } else {
                goals.state(formulas, utterance, words, listener);
              }
            })
        .exceptionally(failure -> refused(failure, words, listener));
  }

  /** What she has asked for last is called off, and what was so before is stated. */
  private void undo(Utterance utterance, GoalWords words, Consumer<ChatEvent> listener) {
    new TakingBack(questions, answers(utterance))
        .last(utterance)
        .thenAccept(
            former -> {
              List<String> wishes = former.stream().flatMap(one -> one.wish().stream()).toList();
              if (!wishes.isEmpty()) {
                goals.state(wishes, utterance, words, listener);
              } else {
                boolean isKnown = former.stream().allMatch(FormerState::isKnown);
                listener.accept(
                    new ChatEvent.Told(
                        "", words.phrase(isKnown ? "undo-nothing" : "undo-unknown")));
              }
            })
        .exceptionally(failure -> refused(failure, words, listener));
  }

  private static void tell(
      CompletableFuture<String> sentence, GoalWords words, Consumer<ChatEvent> listener) {
    sentence
        .thenAccept(text -> listener.accept(new ChatEvent.Told("", text)))
        .exceptionally(failure -> refused(failure, words, listener));
  }

  private static @Nullable Void refused(
      Throwable failure, GoalWords words, Consumer<ChatEvent> listener) {
    listener.accept(
        new ChatEvent.Misunderstood(
            words.report(String.valueOf(WrittenTalk.cause(failure).getMessage())), List.of()));
    return null;
  }

  /** What nobody knows may be found out, if she wishes it. */
  private ChatEvent answered(String question, JsonNode known, GoalWords words) {
    List<AnswerWords.Found> found = FoundAnswers.of(known);
    String answer = spoken.answer(found, question);
    Optional<String> look =
        Optional.of(question)
            .filter(asked -> AnswerWords.isUnknown(found))
            .flatMap(asked -> Looking.goal(asked, around));
    look.ifPresent(goal -> ask(new Open.Look(goal)));
    return look.isPresent()
        ? new ChatEvent.Asked(answer + " " + words.phrase("look"), List.of())
        : new ChatEvent.Told("", answer);
  }

  /** What is not written in MAESTRO-SL may be said as people speak. */
  private SpokenWords.Hearing inWords(Utterance utterance) {
    return isSpoken(utterance) ? spoken.read(utterance) : SpokenWords.Hearing.NONE;
  }

  private static boolean isSpoken(Utterance utterance) {
    String text = utterance.text().strip();
    return !text.startsWith("(") && !text.startsWith("?");
  }

  /** What nobody understands is told as those tell it who know more words. */
  private static Reading withReply(Reading reading, Optional<String> reply) {
    return reading instanceof Reading.Unclear unclear && reply.isPresent()
        ? new Reading.Unclear(reply.get(), unclear.near())
        : reading;
  }

  /** The answers that are known; where more are only likely, these. */
  private CompletableFuture<JsonNode> likely(String asked, Optional<String> reader) {
    Home home = around.home().get();
    Formula formula = SlParser.formula(asked, home.vocabulary()::isFluent);
    Optional<Formula> supposed = home.tracking().flatMap(tracking -> tracking.supposed(formula));
    return questions
        .know(asked, reader)
        .thenCompose(
            known ->
                supposed
                    .map(
                        instead ->
                            questions
                                .know(SlPrinter.print(instead), reader)
                                .thenApply(
                                    likely -> answers(likely) > answers(known) ? likely : known)
                                .exceptionally(failure -> known))
                    .orElseGet(() -> CompletableFuture.completedFuture(known)));
  }

  private static long answers(JsonNode document) {
    return FoundAnswers.of(document).stream().filter(one -> one.truth() == Truth.TRUE).count();
  }

  private static void answer(
      CompletableFuture<JsonNode> known,
      Function<JsonNode, ChatEvent> event,
      GoalWords words,
      Consumer<ChatEvent> listener) {
    known
        .thenAccept(answers -> listener.accept(event.apply(answers)))
        .exceptionally(failure -> refused(failure, words, listener));
  }

  /** All who look read what is answered here: of what is private only what the desk itself may. */
  private static Optional<String> reader(Utterance utterance) {
    return utterance.asker().map(person -> AgentNames.DESK);
  }

  private GoalAnswers answers(Utterance utterance) {
    return new GoalAnswers(around, questions.of(reader(utterance)), stated);
  }
}
