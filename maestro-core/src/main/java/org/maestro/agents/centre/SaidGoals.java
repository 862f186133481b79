package org.maestro.agents.centre;

import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.agents.content.GoalReport;
import org.maestro.agents.content.SayWords;
import org.maestro.agents.content.Words;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;

/**
 * The goals that one sentence states: who said it is told once that they are taken on, and once how
 * all of them ended. Agent thread only.
 */
final class SaidGoals {
  private final List<Formula> goals;
  private final UnfinishedSentence sentence;
  private final String means;
  private final GoalRequests.Verdict verdict;
  private final List<String> accepted = new ArrayList<>();
  private final List<String> refused = new ArrayList<>();
  private final List<Content> ends = new ArrayList<>();
  private boolean reached = true;

  /**
   * @param sentence what was begun of them before all was said
   * @param means the message that the sentence was understood to be
   */
  SaidGoals(
      List<Formula> goals,
      UnfinishedSentence sentence,
      String means,
      GoalRequests.Verdict verdict) {
    this.goals = List.copyOf(goals);
    this.sentence = sentence;
    this.means = means;
    this.verdict = verdict;
  }

  /** What was begun for the goal. */
  Optional<BegunGoal> begun(Formula goal) {
    return sentence.of(goal);
  }

  /** Those that are taken on. */
  List<String> accepted() {
    return List.copyOf(accepted);
  }

  List<Formula> goals() {
    return goals;
  }

  /** The answer to each of them. */
  Coordinator.Answer answer() {
    return new Coordinator.Answer() {
      @Override
      public void accepted(String goalId) {
        accepted.add(goalId);
        answered();
      }

      @Override
      public void refused(String reason) {
        refused.add(reason);
        answered();
      }
    };
  }

  private void answered() {
    if (accepted.size() + refused.size() < goals.size()) {
      return;
    }
    if (accepted.isEmpty()) {
      verdict.told(
          ACLMessage.REFUSE,
          Words.content(
              "inform",
              Words.named("reason", Words.text(refused.get(0))),
              Words.named("temporary", Words.name("true"))));
    } else {
      verdict.told(ACLMessage.AGREE, SayWords.takenOn(means, accepted));
      over();
    }
  }

  /** One of them is over. */
  void ended(Formula goal, GoalOutcome outcome) {
    reached &= outcome.reached();
    ends.add(GoalReport.words(goal, outcome));
    over();
  }

  private void over() {
    if (ends.size() == accepted.size() && ends.size() + refused.size() == goals.size()) {
      refused.forEach(
          reason -> ends.add(Words.content("inform", Words.named("reason", Words.text(reason)))));
      verdict.told(
          reached && refused.isEmpty() ? ACLMessage.INFORM : ACLMessage.FAILURE,
          ends.toArray(Content[]::new));
    }
  }
}
