package org.maestro.coordination.maintenance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.StringJoiner;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.coordination.story.GoalStory;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.Term;

/** Tells how a held goal fares. */
final class HeldStory {
  private final String goalId;
  private final Ports ports;
  private final GoalStory goal;

  /** Entries that are told only if more becomes of it; empty: each is told at once. */
  private Optional<List<StoryEntry>> heldBack = Optional.empty();

  HeldStory(String goalId, Ports ports) {
    this.goalId = goalId;
    this.ports = ports;
    this.goal = new GoalStory(goalId, ports.story(), ports.clock(), ports.knowledge());
  }

  /** How it began, and how it ended. */
  GoalStory goal() {
    return goal;
  }

  /**
   * It is tried to bring it about.
   *
   * @param again after it could not be; then nothing is told unless there is a plan this time
   */
  void begin(boolean again) {
    heldBack = again ? Optional.of(new ArrayList<>()) : Optional.empty();
  }

  /** What is done to bring it about is part of the story; that this ends is not its end. */
  void tellOfWork(StoryEntry entry) {
    switch (entry.kind()) {
      case GOAL, KNOWN, END -> {
        // Told for the goal as a whole.
      }
      case BIDS, REPLAN, WAIT ->
          heldBack.ifPresentOrElse(entries -> entries.add(entry), () -> ports.story().tell(entry));
      default -> {
        heldBack.ifPresent(entries -> entries.forEach(ports.story()::tell));
        heldBack = Optional.empty();
        ports.story().tell(entry);
      }
    }
  }

  void holds(Formula condition, boolean again, Evidence evidence, boolean confirmed) {
    tell(
        StoryEntry.Kind.HELD,
        "It is so"
            + (again ? " again" : ", and is kept so")
            + quantities(condition)
            + (confirmed ? "" : "; nobody has seen it but who says so")
            + (evidence == Evidence.KNOWN
                ? "; nobody can observe it all the time, it is so by what is known."
                : "."));
  }

  void lost(Formula condition) {
    tell(StoryEntry.Kind.LOST, "It is no longer so" + quantities(condition) + ".");
  }

  void cannotBeHeld(List<String> reasons) {
    tell(
        StoryEntry.Kind.LOST,
        "It cannot be kept so now. "
            + String.join(" ", reasons)
            + " It is tried again when something changes.");
  }

  void cheaper(CheaperSettings.Cheaper cheaper) {
    tell(
        StoryEntry.Kind.REPLAN,
        "It can be kept at cost "
            + Sentences.number(cheaper.cost())
            + " instead of "
            + Sentences.number(cheaper.instead())
            + ": the settings are made anew.");
  }

  /** The numbers that the condition names, as they are known now. */
  private String quantities(Formula condition) {
    Snapshot now = ports.knowledge().snapshot();
    Sentences sentences = new Sentences(ports.knowledge().home().vocabulary());
    StringJoiner told = new StringJoiner(", ", ": ", "").setEmptyValue("");
    Leaves.of(
        condition,
        atom -> {},
        fluent -> {
          if (fluent.arguments().stream().allMatch(Term::isGround)
              && now.belief(fluent).isPresent()
              && now.number(fluent).isPresent()) {
            told.add(
                sentences.fact(
                    new Formula.Comparison(
                        Formula.Relation.EQUAL,
                        fluent,
                        new Expression.OfTerm(new Term.Number(now.number(fluent).getAsDouble())))));
          }
        });
    return told.toString();
  }

  private void tell(StoryEntry.Kind kind, String text) {
    ports.story().tell(new StoryEntry(goalId, ports.clock().now(), kind, text));
  }
}
