package org.maestro.console.chat;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Consumer;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.AskedGoal;
import org.maestro.agents.content.GoalReport;
import org.maestro.console.questions.AclQuestions;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.dialogue.Reading;
import org.maestro.dialogue.SpokenWords;
import org.maestro.dialogue.Utterance;

/**
 * What is written in MAESTRO-SL or in the names of the home: it is answered with what stands in
 * stories and documents. Any thread may use it.
 */
final class WrittenTalk {
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

  private final Surroundings around;
  private final SpokenWords spoken;
  private final AclQuestions questions;
  private final GoalStories stories;
  private final StatedGoals stated;

  /** What was said, and where, of a goal that lacks its last part; guarded by this. */
  private Optional<Utterance> unfinished = Optional.empty();

  /**
   * @param spoken the conversation with the person who is answered
   */
  WrittenTalk(
      Surroundings around,
      SpokenWords spoken,
      AclQuestions questions,
      GoalStories stories,
      StatedGoals stated) {
    this.around = around;
    this.spoken = spoken;
    this.questions = questions;
    this.stories = stories;
    this.stated = stated;
  }

  private WrittenWords words() {
    return new WrittenWords(around.home().get());
  }

  /** What answers the question that was asked last is read with what that was about. */
  synchronized Reading read(Utterance utterance) {
    WrittenWords words = words();
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
    return now.saying(before.text() + " " + now.text()).in(before.room());
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

  /** Does what it was read as. */
  void respond(Reading reading, Utterance utterance, Consumer<ChatEvent> listener) {
    WrittenWords words = words();
    if (reading instanceof Reading.Goal goal) {
      state(goal.formula(), utterance, listener, words);
    } else if (reading instanceof Reading.Question question) {
      ask(question.formula(), utterance.asker(), listener, words);
    } else if (reading instanceof Reading.Unfinished part) {
      listener.accept(questionBack(part, words));
    } else if (reading instanceof Reading.Unclear unclear) {
      listener.accept(new ChatEvent.Misunderstood(unclear.why(), unclear.near()));
    }
  }

  /** The central agent refuses what may not be; she is told why in her own language. */
  private void state(
      String goal, Utterance utterance, Consumer<ChatEvent> listener, WrittenWords words) {
    StatedGoals.Stated how =
        new StatedGoals.Stated(utterance.person(), utterance.text(), stated.turn());
    CompletableFuture<GoalReport> report = new CompletableFuture<>();
    Optional<String> refusal = spoken.refusal(goal, utterance);
    questions
        .state(
            new AskedGoal(goal).person(utterance.asker()).speaker(Optional.of(utterance.person())),
            report::complete)
        .thenAccept(
            id -> {
              stated.stated(id, how);
              listener.accept(new ChatEvent.Understood(id, goal));
              follow(id, report, refusal, listener);
            })
        .exceptionally(
            failure -> {
              listener.accept(misunderstood(goal, failure, words));
              return null;
            });
  }

  private void follow(
      String id,
      CompletableFuture<GoalReport> report,
      Optional<String> refusal,
      Consumer<ChatEvent> listener) {
    stories.follow(
        id,
        entry -> {
          if (entry.kind() == StoryEntry.Kind.END) {
            report
                .thenAccept(
                    ended ->
                        listener.accept(
                            new ChatEvent.Ended(
                                id,
                                ended.reached(),
                                ended.reached() ? entry.text() : refusal.orElse(entry.text()))))
                .exceptionally(failure -> null);
          } else if (TOLD.contains(entry.kind())) {
            listener.accept(new ChatEvent.Told(id, entry.text()));
          }
        });
  }

  /** All who look read what is answered here: of what is private only what the desk itself may. */
  private void ask(
      String question, Optional<String> asker, Consumer<ChatEvent> listener, WrittenWords words) {
    questions
        .know(question, asker.map(person -> AgentNames.DESK))
        .thenAccept(known -> tell(known, listener))
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
    return new ChatEvent.Misunderstood(
        String.valueOf(cause(refusal).getMessage()), words.near(said));
  }

  static Throwable cause(Throwable failure) {
    return failure instanceof CompletionException && failure.getCause() != null
        ? failure.getCause()
        : failure;
  }
}
