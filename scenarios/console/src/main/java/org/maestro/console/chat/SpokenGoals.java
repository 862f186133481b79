package org.maestro.console.chat;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.AskedGoal;
import org.maestro.agents.content.GoalReport;
import org.maestro.console.access.Readership;
import org.maestro.console.questions.AclQuestions;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.dialogue.SpokenWords;
import org.maestro.dialogue.Utterance;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.language.wording.GoalWords;
import org.maestro.language.wording.Wish;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * States goals that were said in words, and tells in words what becomes of them. Any thread may use
 * it.
 */
final class SpokenGoals {
  private static final Pattern GOAL = Pattern.compile("\\bG\\d+(\\.\\d+)*\\b");
  private static final double A_WHILE_SECONDS = 3;
  private static final Duration LONG = Duration.ofMinutes(1);
  private static final Set<StoryEntry.Kind> TOLD =
      EnumSet.of(StoryEntry.Kind.MISCONDUCT, StoryEntry.Kind.LOST, StoryEntry.Kind.RESTART);

  private final Surroundings around;
  private final SpokenWords conversation;
  private final AclQuestions questions;
  private final GoalStories stories;
  private final StatedGoals stated;

  SpokenGoals(
      Surroundings around,
      SpokenWords conversation,
      AclQuestions questions,
      GoalStories stories,
      StatedGoals stated) {
    this.around = around;
    this.conversation = conversation;
    this.questions = questions;
    this.stories = stories;
    this.stated = stated;
  }

  /** All that one utterance states; where she may not have a part done, nothing else is begun. */
  void state(
      List<String> goals, Utterance utterance, GoalWords words, Consumer<ChatEvent> listener) {
    long turn = stated.turn();
    List<Course> all =
        goals.stream().map(goal -> new Course(goal, utterance, turn, words, listener)).toList();
    List<Course> refused = all.stream().filter(Course::isRefused).toList();
    (refused.isEmpty() ? all : refused).forEach(Course::begin);
  }

  /** What becomes of one goal. */
  private final class Course {
    private final String text;
    private final Optional<Formula> formula;
    private final Optional<String> refusal;
    private final Utterance utterance;
    private final long turn;
    private final GoalWords words;
    private final Consumer<ChatEvent> listener;
    private final AclQuestions reading;
    private final AtomicBoolean isOver = new AtomicBoolean();
    private final CompletableFuture<GoalReport> report = new CompletableFuture<>();
    private final Set<String> toldSteps = new HashSet<>();
    private boolean isForetold;

    Course(
        String text,
        Utterance utterance,
        long turn,
        GoalWords words,
        Consumer<ChatEvent> listener) {
      this.text = text;
      this.formula = KnownGoal.formula(text, around.home().get());
      this.refusal = conversation.refusal(text, utterance);
      this.utterance = utterance;
      // All who look read what is told here: of what is private only what the desk itself may.
      this.reading = questions.of(utterance.asker().map(person -> AgentNames.DESK));
      this.turn = turn;
      this.words = words;
      this.listener = listener;
    }

    private Wish wish() {
      return new Wish(
          formula, Optional.of(utterance.text()), Optional.of(utterance.person()), Duration.ZERO);
    }

    boolean isRefused() {
      return refusal.isPresent();
    }

    /** The central agent refuses what may not be; she is told why in her own language. */
    void begin() {
      questions
          .state(
              new AskedGoal(text)
                  .person(utterance.asker())
                  .speaker(Optional.of(utterance.person())),
              utterance.room(),
              report::complete)
          .thenAccept(
              id -> {
                stated.stated(
                    id, new StatedGoals.Stated(utterance.person(), utterance.text(), turn));
                listener.accept(
                    new ChatEvent.Understood(
                        id, isRefused() ? words.reason(wish()) : words.accepted(wish())));
                if (!GOAL.matcher(id).matches()) {
                  tell(id, words.phrase("room-alone"));
                }
                stories.follow(id, entry -> happened(id, entry));
              })
          .exceptionally(
              failure -> {
                listener.accept(refused(failure));
                return null;
              });
    }

    private ChatEvent refused(Throwable failure) {
      String cause = String.valueOf(WrittenTalk.cause(failure).getMessage());
      return new ChatEvent.Misunderstood(words.failed(wish(), List.of(spoken(cause))), List.of());
    }

    /** Other goals have no names that people know. */
    private String spoken(String sentence) {
      return GOAL.matcher(sentence).replaceAll(words.phrase("all-doing"));
    }

    private void tell(String id, String sentence) {
      if (!isOver.get()) {
        listener.accept(new ChatEvent.Told(id, sentence));
      }
    }

    private void happened(String id, StoryEntry entry) {
      switch (entry.kind()) {
        case END ->
            report.thenAccept(ended -> end(id, ended, entry)).exceptionally(failure -> null);
        case HELD -> tell(id, words.reached(formula, true));
        case STEP ->
            reading.plans(id).thenAccept(plans -> steps(id, plans)).exceptionally(failure -> null);
        case WAIT ->
            new GoalAnswers(around, reading, stated)
                .goals()
                .thenAccept(goals -> waits(id, goals))
                .exceptionally(f -> null);
        default -> {
          if (TOLD.contains(entry.kind())) {
            tell(id, words.report(spoken(entry.text())));
          }
        }
      }
    }

    /** What another goal keeps from it. */
    private void waits(String id, List<KnownGoal> goals) {
      List<Wish> holders =
          goals.stream()
              .filter(goal -> goal.id().equals(id))
              .flatMap(goal -> goal.holders().stream())
              .flatMap(holder -> goals.stream().filter(goal -> goal.id().equals(holder)))
              .map(KnownGoal::wish)
              .toList();
      if (!holders.isEmpty()) {
        tell(id, words.waitsFor(holders));
      }
    }

    /** Each step that takes a while, when it has begun. */
    private synchronized void steps(String id, JsonNode plans) {
      foretell(id, plans);
      for (JsonNode plan : plans.path("plans")) {
        for (JsonNode step : plan.path("steps")) {
          String key = plan.path("number").asText() + "." + step.path("number").asText();
          if (plan.path("steps").size() > 1
              && step.path("state").asText().equals("under-way")
              && step.path("duration_s").asDouble() >= A_WHILE_SECONDS
              && toldSteps.add(key)) {
            tell(
                id,
                words.step(
                    step.path("member").asText(),
                    step.path("feature").asText(),
                    step.path("text").asText()));
          }
        }
      }
    }

    /** Once, when it takes long until it is so. */
    private void foretell(String id, JsonNode plans) {
      Optional<String> foretold =
          Remaining.of(plans, around.now().get())
              .filter(rest -> !isForetold && rest.compareTo(LONG) >= 0)
              .flatMap(rest -> words.foretold(formula, rest));
      isForetold |= foretold.isPresent();
      foretold.ifPresent(sentence -> tell(id, sentence));
    }

    private void end(String id, GoalReport ended, StoryEntry entry) {
      isOver.set(true);
      boolean isPrivate = Readership.isInstead(entry);
      if (!isPrivate && ended.state() == GoalState.FAILED) {
        stated.failed(
            id,
            refusal
                .map(List::of)
                .orElseGet(() -> ended.reasons().stream().map(this::spoken).toList()));
      }
      listener.accept(
          new ChatEvent.Ended(id, ended.reached(), isPrivate ? entry.text() : sentence(ended)));
    }

    private String sentence(GoalReport ended) {
      return switch (ended.state()) {
        case ACHIEVED -> reached(ended);
        case CANCELLED -> words.calledOff(wish());
        default ->
            refusal.orElseGet(
                () ->
                    words.failed(
                        wish(), ended.reasons().stream().limit(1).map(this::spoken).toList()));
      };
    }

    private String reached(GoalReport ended) {
      Optional<Formula> found = formula.map(new Substitution(ended.binding())::apply);
      return words.reached(found, ended.confirmed() || found.filter(this::isTold).isPresent());
    }

    /** Whether it was seen, or is told by the device itself that is in that state. */
    private boolean isTold(Formula formula) {
      Snapshot snapshot = around.facts().get();
      boolean[] all = {true};
      Leaves.of(
          formula,
          atom -> all[0] &= atom.isGround() && isTold(snapshot.belief(atom)),
          fluent ->
              all[0] &=
                  fluent.arguments().stream().allMatch(Term::isGround)
                      && isTold(snapshot.belief(fluent)));
      return all[0];
    }

    private static boolean isTold(Optional<Belief> belief) {
      return belief.filter(one -> one.source().kind() != Source.Kind.EXPECTED).isPresent();
    }
  }
}
