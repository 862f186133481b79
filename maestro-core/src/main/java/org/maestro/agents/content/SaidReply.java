package org.maestro.agents.content;

import java.util.List;

/** What is answered to something that a person has said. */
public sealed interface SaidReply {

  /**
   * It was understood as goals, which are taken on.
   *
   * @param means the message that it was understood to be
   * @param goals their ids
   */
  record TakenOn(String means, List<String> goals) implements SaidReply {
    public TakenOn {
      goals = List.copyOf(goals);
    }
  }

  /** The goals that were taken on are over. */
  record Over(List<GoalReport> ends) implements SaidReply {
    public Over {
      ends = List.copyOf(ends);
    }

    /** Whether all of them were reached. */
    public boolean reached() {
      return ends.stream().allMatch(GoalReport::reached);
    }
  }

  /**
   * It was a question, or nothing that anything follows from.
   *
   * @param means the message that it was understood to be; "" of none
   */
  record Replied(String means, String text) implements SaidReply {}

  /** A question back, which whatever she says next may answer. */
  record Asked(String question) implements SaidReply {}

  /** It was taken as the answer to a script. */
  record Answered(String part) implements SaidReply {}

  /**
   * Not who heard it has understood it, but another room agent, which answers.
   *
   * @param agent its name
   * @param laterSeconds how much later the answer comes by that
   */
  record PassedOn(String agent, double laterSeconds, SaidReply answer) implements SaidReply {}

  /** Nothing comes of it. */
  record Refused(String why) implements SaidReply {}
}
