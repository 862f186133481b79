package org.maestro.console.chat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.maestro.console.questions.AclQuestions;
import org.maestro.console.questions.FormerState;
import org.maestro.dialogue.Utterance;

/**
 * Takes back what somebody has asked for last: what goes on for it is called off, and it is found
 * out what was so before. Any thread may use it.
 */
final class TakingBack {
  private final AclQuestions questions;
  private final GoalAnswers answers;

  TakingBack(AclQuestions questions, GoalAnswers answers) {
    this.questions = questions;
    this.answers = answers;
  }

  /** What was so before each of the goals that she has asked for last, the latest first. */
  CompletableFuture<List<FormerState>> last(Utterance utterance) {
    return answers
        .goals()
        .thenCompose(
            all -> {
              List<KnownGoal> last = new ArrayList<>(lastOf(all, utterance.person()));
              Collections.reverse(last);
              return before(last, utterance);
            });
  }

  /** The newest goal that is hers, in whichever way it was stated, and those of its turn. */
  private static List<KnownGoal> lastOf(List<KnownGoal> all, String person) {
    List<KnownGoal> own = all.stream().filter(goal -> goal.isBy(person)).toList();
    if (own.isEmpty()) {
      return own;
    }
    KnownGoal newest = own.get(own.size() - 1);
    return newest.turn() == 0
        ? List.of(newest)
        : own.stream().filter(goal -> goal.turn() == newest.turn()).toList();
  }

  private CompletableFuture<List<FormerState>> before(List<KnownGoal> goals, Utterance utterance) {
    CompletableFuture<List<FormerState>> all = CompletableFuture.completedFuture(List.of());
    for (KnownGoal goal : goals) {
      all = all.thenCombine(before(goal, utterance), TakingBack::with);
    }
    return all;
  }

  private CompletableFuture<FormerState> before(KnownGoal goal, Utterance utterance) {
    CompletableFuture<Void> over =
        goal.isOver()
            ? CompletableFuture.completedFuture(null)
            : questions.cancel(goal.id(), utterance.asker());
    return over.thenCompose(done -> questions.before(goal.id()));
  }

  private static List<FormerState> with(List<FormerState> several, FormerState one) {
    List<FormerState> all = new ArrayList<>(several);
    all.add(one);
    return List.copyOf(all);
  }
}
