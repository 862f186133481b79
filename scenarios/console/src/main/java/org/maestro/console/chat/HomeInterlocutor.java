package org.maestro.console.chat;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Instant;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.AskedGoal;
import org.maestro.agents.content.GoalReport;
import org.maestro.console.questions.AclQuestions;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Facts;

/**
 * An interlocutor who understands what people say in their language, and reads goals and questions
 * as they are written, too; states the goals, and tells how they fare in the sentences of their
 * stories.
 */
public final class WrittenInterlocutor implements Interlocutor {
  private static final int MOST_CHOICES = 12;
  private static final Set<StoryEntry.Kind> TOLD =
      EnumSet.of(
          StoryEntry.Kind.PLAN,
          StoryEntry.Kind.WAIT,
          StoryEntry.Kind.STEP,
          StoryEntry.Kind.FAILED,
          StoryEntry.Kind.MISCONDUCT,
          StoryEntry.Kind.REPLAN,
          StoryEntry.Kind.CONFIRM,
          StoryEntry.Kind.SEARCHED,
          StoryEntry.Kind.HELD,
          StoryEntry.Kind.LOST,
          StoryEntry.Kind.RESTART);

  private final Supplier<Home> home;
  private final AclQuestions questions;
  private final GoalStories stories;
  private final SpokenWords spoken;

  /** What was said, and where, of a goal that lacks its last part; guarded by this. */
  private Optional<Utterance> unfinished = Optional.empty();

  /**
   * @param home as it is known at the time
   * @param facts what is known at the time
   * @param now the time that clocks on the walls show
   */
  public WrittenInterlocutor(
      Supplier<Home> home,
      Supplier<? extends Facts> facts,
      Supplier<Instant> now,
      AclQuestions questions,
      GoalStories stories) {
    this.home = home;
    this.spoken = new SpokenWords(home, facts, now);
    this.questions = questions;
    this.stories = stories;
  }

  @Override
  public void hear(Utterance utterance, Consumer<ChatEvent> listener) {
    WrittenWords words = new WrittenWords(home.get());
    SpokenWords.Hearing heard = inWords(utterance);
    Reading reading =
        heard.reading().orElseGet(() -> withReply(read(words, utterance), heard.reply()));
    if (reading instanceof Reading.Goals goals) {
      goals.formulas().forEach(goal -> state(goal, utterance.asker(), listener, words));
    } else if (reading instanceof Reading.Said said) {
      listener.accept(new ChatEvent.Told("", said.text()));
    } else if (reading instanceof Reading.Back back) {
      listener.accept(new ChatEvent.Asked(back.text(), back.choices()));
    } else if (reading instanceof Reading.Counted counted) {
      answer(
          counted.formula(),
          answers -> spoken.counted(answers, counted.formula()),
          utterance.asker(),
          listener,
          words);
    } else if (reading instanceof Reading.Asked asked) {
      answer(asked.formula(), spoken::answer, utterance.asker(), listener, words);
    } else if (reading instanceof Reading.Goal goal) {
      state(goal.formula(), utterance.asker(), listener, words);
    } else if (reading instanceof Reading.Question question) {
      ask(question.formula(), utterance.asker(), listener, words);
    } else if (reading instanceof Reading.Unfinished part) {
      listener.accept(questionBack(part, words));
    } else if (reading instanceof Reading.Unclear unclear) {
      listener.accept(new ChatEvent.Misunderstood(unclear.why(), unclear.near()));
    }
  }

  /** What is not written in MAESTRO-SL may be said as people speak. */
  private SpokenWords.Hearing inWords(Utterance utterance) {
    String text = utterance.text().strip();
    return text.startsWith("(") || text.startsWith("?")
        ? new SpokenWords.Hearing(Optional.empty(), Optional.empty())
        : spoken.read(utterance);
  }

  /** What nobody understands is told as those tell it who know more words. */
  private static Reading withReply(Reading reading, Optional<String> reply) {
    return reading instanceof Reading.Unclear unclear && reply.isPresent()
        ? new Reading.Unclear(reply.get(), unclear.near())
        : reading;
  }

  /** What answers the question that was asked last is read with what that was about. */
  private synchronized Reading read(WrittenWords words, Utterance utterance) {
    Reading alone = words.read(utterance);
    Optional<Utterance> together =
        unfinished
            .filter(before -> alone instanceof Reading.Unclear)
            .map(before -> joined(before, utterance))
            .filter(both -> !(words.read(both) instanceof Reading.Unclear));
    Utterance whole = together.orElse(utterance);
    Reading reading = together.isPresent() ? words.read(whole) : alone;
    unfinished = reading instanceof Reading.Unfinished ? Optional.of(whole) : Optional.empty();
    return reading;
  }

  /** Here is where it was begun. */
  private static Utterance joined(Utterance before, Utterance now) {
    return new Utterance(
        before.person(), before.room(), before.text() + " " + now.text(), now.asker());
  }

  private static ChatEvent questionBack(Reading.Unfinished part, WrittenWords words) {
    List<String> choices = words.choices(part.wanted());
    return new ChatEvent.Asked(
        part.wanted().isEmpty()
            ? "%s: at least how much? Say a number.".formatted(part.begin())
            : "%s: which %s? Say its name.".formatted(part.begin(), asWords(part.wanted())),
        choices.stream().limit(MOST_CHOICES).toList());
  }

  private static String asWords(String className) {
    return className.replaceAll("(?<=[a-z])(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
  }

  private void state(
      String goal, Optional<String> asker, Consumer<ChatEvent> listener, WrittenWords words) {
    CompletableFuture<GoalReport> report = new CompletableFuture<>();
    questions
        .state(new AskedGoal(goal).person(asker), report::complete)
        .thenAccept(
            id -> {
              listener.accept(new ChatEvent.Understood(id, goal));
              follow(id, report, listener);
            })
        .exceptionally(
            refusal -> {
              listener.accept(misunderstood(goal, refusal, words));
              return null;
            });
  }

  private void follow(
      String id, CompletableFuture<GoalReport> report, Consumer<ChatEvent> listener) {
    stories.follow(
        id,
        entry -> {
          if (entry.kind() == StoryEntry.Kind.END) {
            report
                .thenAccept(
                    ended ->
                        listener.accept(new ChatEvent.Ended(id, ended.reached(), entry.text())))
                .exceptionally(failure -> null);
          } else if (TOLD.contains(entry.kind())) {
            listener.accept(new ChatEvent.Told(id, entry.text()));
          }
        });
  }

  /** All who look read what is answered here: of what is private only what the desk itself may. */
  private void answer(
      String question,
      Function<JsonNode, String> sentence,
      Optional<String> asker,
      Consumer<ChatEvent> listener,
      WrittenWords words) {
    questions
        .know(question, asker.map(person -> AgentNames.DESK))
        .thenAccept(answers -> listener.accept(new ChatEvent.Told("", sentence.apply(answers))))
        .exceptionally(
            refusal -> {
              listener.accept(misunderstood(question, refusal, words));
              return null;
            });
  }

  /** All who look read what is answered here: of what is private only what the desk itself may. */
  private void ask(
      String question, Optional<String> asker, Consumer<ChatEvent> listener, WrittenWords words) {
    questions
        .know(question, asker.map(person -> AgentNames.DESK))
        .thenAccept(answers -> tell(answers, listener))
        .exceptionally(
            refusal -> {
              listener.accept(misunderstood(question, refusal, words));
              return null;
            });
  }

  private static void tell(JsonNode document, Consumer<ChatEvent> listener) {
    AnswerSentences.of(document)
        .forEach(sentence -> listener.accept(new ChatEvent.Told("", sentence)));
  }

  private static ChatEvent misunderstood(String said, Throwable refusal, WrittenWords words) {
    Throwable cause =
        refusal instanceof CompletionException && refusal.getCause() != null
            ? refusal.getCause()
            : refusal;
    return new ChatEvent.Misunderstood(String.valueOf(cause.getMessage()), words.near(said));
  }
}
