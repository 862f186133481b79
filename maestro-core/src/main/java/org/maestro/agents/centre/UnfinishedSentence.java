package org.maestro.agents.centre;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Formula;

/** What was begun for what somebody is saying. Agent thread only. */
final class UnfinishedSentence {
  private final Map<Formula, BegunGoal> begun = new LinkedHashMap<>();
  private List<Formula> wanted = List.of();
  private Optional<Clock.Timer> silence = Optional.empty();
  private int words;

  /** All that is wanted by what was said so far, or in the end. */
  List<Formula> wanted() {
    return wanted;
  }

  /** What was begun and is wanted no more, by what is wanted now; it is forgotten here. */
  List<BegunGoal> wants(List<Formula> now) {
    wanted = List.copyOf(now);
    List<BegunGoal> unwanted =
        begun.values().stream().filter(goal -> !wanted.contains(goal.goal())).toList();
    unwanted.forEach(goal -> begun.remove(goal.goal()));
    return unwanted;
  }

  /** Begins what is wanted and was not begun, or could not be. */
  List<BegunGoal> begin() {
    List<BegunGoal> all = new ArrayList<>();
    for (Formula goal : wanted) {
      if (of(goal).isEmpty()) {
        BegunGoal one = new BegunGoal(goal);
        begun.put(goal, one);
        all.add(one);
      }
    }
    return all;
  }

  Optional<BegunGoal> of(Formula goal) {
    return Optional.ofNullable(begun.get(goal)).filter(one -> !one.isRefused());
  }

  /** Of those that are taken on. */
  List<String> ids() {
    return begun.values().stream().flatMap(goal -> goal.id().stream()).toList();
  }

  /** Another word was heard, or none is to come; returns how many were. */
  int heard() {
    silence.ifPresent(Clock.Timer::cancel);
    silence = Optional.empty();
    return ++words;
  }

  void waits(Clock.Timer timer) {
    silence = Optional.of(timer);
  }

  /** Whether no word was heard since so many were. */
  boolean isSilentSince(int heard) {
    return words == heard;
  }
}
