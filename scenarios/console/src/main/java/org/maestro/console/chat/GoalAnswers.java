package org.maestro.console.chat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.maestro.console.questions.AclQuestions;
import org.maestro.coordination.api.GoalState;
import org.maestro.dialogue.Reading;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.language.wording.GoalWords;
import org.maestro.language.wording.Wish;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Truth;

/**
 * Answers what is asked about what is being done, and why: from the goals, their plans, and what is
 * known. Any thread may ask.
 */
final class GoalAnswers {
  private static final int MOST = 3;
  private static final int MOST_LOOKED_THROUGH = 20;

  private final Surroundings around;
  private final AclQuestions questions;
  private final StatedGoals stated;

  GoalAnswers(Surroundings around, AclQuestions questions, StatedGoals stated) {
    this.around = around;
    this.questions = questions;
    this.stated = stated;
  }

  /** All goals, the latest last. */
  CompletableFuture<List<KnownGoal>> goals() {
    return questions
        .goals()
        .thenApply(document -> KnownGoal.all(document, stated, around.home().get()));
  }

  /** The sentence for her. */
  CompletableFuture<String> of(Reading.About about, String person, GoalWords words) {
    return goals()
        .thenCompose(
            goals ->
                switch (about.what()) {
                  case DOING -> told(doing(goals, words));
                  case DONE -> told(words.done(wishes(latest(goals, this::isReached))));
                  case PLANNED -> told(words.planned(wishes(open(goals, KnownGoal::isLater))));
                  case ASKED -> told(words.asked(wishes(latest(goals, goal -> goal.isBy(person)))));
                  case WHETHER_DONE -> told(whetherDone(goals, person, words));
                  case LASTS -> lasts(goals, person, words);
                  case WHO ->
                      concerning(about.formula(), goals, person)
                          .thenApply(
                              goal ->
                                  goal.map(one -> words.doer(one.wish()))
                                      .orElseGet(() -> unknown(about.formula(), words)));
                  case WHY ->
                      concerning(about.formula(), goals, person)
                          .thenApply(
                              goal ->
                                  goal.map(one -> why(one, words))
                                      .orElseGet(() -> unknown(about.formula(), words)));
                });
  }

  private static CompletableFuture<String> told(String sentence) {
    return CompletableFuture.completedFuture(sentence);
  }

  private boolean isReached(KnownGoal goal) {
    return goal.state() == GoalState.ACHIEVED;
  }

  private static List<KnownGoal> open(List<KnownGoal> goals, Predicate<KnownGoal> which) {
    return goals.stream().filter(goal -> !goal.isOver()).filter(which).toList();
  }

  /** The latest of these, the very latest first. */
  private static List<KnownGoal> latest(List<KnownGoal> goals, Predicate<KnownGoal> which) {
    List<KnownGoal> all = new ArrayList<>(goals.stream().filter(which).toList());
    Collections.reverse(all);
    return all.subList(0, Math.min(MOST, all.size()));
  }

  private static List<Wish> wishes(List<KnownGoal> goals) {
    return goals.stream().map(KnownGoal::wish).toList();
  }

  private static String doing(List<KnownGoal> goals, GoalWords words) {
    List<KnownGoal> now = open(goals, goal -> !goal.isLater());
    List<KnownGoal> held = open(goals, goal -> goal.isLater() && !goal.holders().isEmpty());
    return now.isEmpty() && !held.isEmpty()
        ? waits(held.get(0), goals, words)
        : words.doing(wishes(now));
  }

  private static String waits(KnownGoal goal, List<KnownGoal> goals, GoalWords words) {
    return words.waitsFor(
        wishes(goals.stream().filter(one -> goal.holders().contains(one.id())).toList()));
  }

  /** What she has asked for last, or else what anybody has. */
  private static Optional<KnownGoal> last(List<KnownGoal> goals, String person) {
    return Stream.concat(
            latest(goals, goal -> goal.isBy(person)).stream(), latest(goals, goal -> true).stream())
        .findFirst();
  }

  private static String whetherDone(List<KnownGoal> goals, String person, GoalWords words) {
    return last(goals, person)
        .map(
            goal ->
                switch (goal.state()) {
                  case ACHIEVED -> "done-yes";
                  case FAILED -> "done-failed";
                  case CANCELLED -> "called-off";
                  default -> "done-no";
                })
        .map(words::phrase)
        .orElseGet(() -> words.phrase("asked-nothing"));
  }

  private CompletableFuture<String> lasts(List<KnownGoal> goals, String person, GoalWords words) {
    Optional<KnownGoal> asked =
        Stream.concat(
                latest(goals, goal -> !goal.isOver() && goal.isBy(person)).stream(),
                latest(goals, goal -> !goal.isOver()).stream())
            .findFirst();
    if (asked.isEmpty()) {
      return told(words.phrase("doing-nothing"));
    }
    KnownGoal goal = asked.get();
    if (goal.state() == GoalState.HOLDING) {
      return told(words.phrase("lasts-until"));
    } else if (!goal.holders().isEmpty()) {
      return told(waits(goal, goals, words));
    }
    return questions
        .plans(goal.id())
        .thenApply(
            plans ->
                Remaining.of(plans, around.now().get())
                    .map(words::lasts)
                    .orElseGet(() -> words.phrase("lasts-unknown")));
  }

  private String why(KnownGoal goal, GoalWords words) {
    List<String> reasons = stated.reasons(goal.id());
    return reasons.isEmpty() ? words.reason(goal.wish()) : words.failed(goal.wish(), reasons);
  }

  /**
   * The latest goal that brought it about, or had to do with its things.
   *
   * @param spoken empty: what she has asked for last
   */
  private CompletableFuture<Optional<KnownGoal>> concerning(
      Optional<Formula> spoken, List<KnownGoal> goals, String person) {
    if (spoken.isEmpty()) {
      return CompletableFuture.completedFuture(last(goals, person));
    }
    List<KnownGoal> begun =
        goals.stream()
            .filter(goal -> goal.state() != GoalState.FAILED)
            .filter(goal -> !goal.isLater() || goal.isOver() || isRule(goal))
            .toList();
    List<KnownGoal> direct =
        latest(
            begun, goal -> goal.formula().filter(f -> Concern.isOf(f, spoken.get())).isPresent());
    return direct.isEmpty()
        ? byItsSteps(spoken.get(), begun)
        : CompletableFuture.completedFuture(direct.stream().findFirst());
  }

  private static boolean isRule(KnownGoal goal) {
    return goal.formula().filter(Formula.Bound.class::isInstance).isPresent();
  }

  /** The latest goal for which a thing that is spoken of has done something. */
  private CompletableFuture<Optional<KnownGoal>> byItsSteps(Formula spoken, List<KnownGoal> goals) {
    if (truth(spoken) == Truth.FALSE) {
      return CompletableFuture.completedFuture(Optional.empty());
    }
    Collection<String> things = Concern.things(spoken);
    CompletableFuture<Optional<KnownGoal>> found =
        CompletableFuture.completedFuture(Optional.empty());
    List<KnownGoal> recent =
        new ArrayList<>(
            goals.subList(Math.max(0, goals.size() - MOST_LOOKED_THROUGH), goals.size()));
    Collections.reverse(recent);
    for (KnownGoal goal : recent) {
      found =
          found.thenCompose(
              before ->
                  before.isPresent()
                      ? CompletableFuture.completedFuture(before)
                      : questions
                          .plans(goal.id())
                          .thenApply(
                              plans ->
                                  Optional.of(goal).filter(one -> StepsDone.by(plans, things))));
    }
    return found;
  }

  /** All who look read the answer: of what is private nothing is known. */
  private Truth truth(Formula formula) {
    return isReadByAll(formula)
        ? new Evaluation(around.facts().get()).truth(formula, Map.of())
        : Truth.UNKNOWN;
  }

  private boolean isReadByAll(Formula formula) {
    return around.readership().ofAll().objection(formula).isEmpty();
  }

  /** Nobody knows why it is so; since when it is so may be known. */
  private String unknown(Optional<Formula> formula, GoalWords words) {
    if (formula.isEmpty()) {
      return words.phrase("asked-nothing");
    } else if (truth(formula.get()) == Truth.FALSE) {
      return words.phrase("because-not-so");
    }
    String unknown = words.phrase("because-unknown");
    return formula
        .filter(this::isReadByAll)
        .flatMap(this::since)
        .map(span -> unknown + " " + words.since(span))
        .orElse(unknown);
  }

  private Optional<Duration> since(Formula formula) {
    Snapshot snapshot = around.facts().get();
    Optional<Belief> belief =
        formula instanceof Formula.Atom atom
            ? snapshot.belief(atom)
            : formula instanceof Formula.Comparison comparison
                    && comparison.left() instanceof Expression.Fluent fluent
                ? snapshot.belief(fluent)
                : Optional.empty();
    return belief.map(one -> one.age(snapshot.at()));
  }
}
