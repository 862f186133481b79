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

  /** All that is wanted by what was said so far, or in the end. */
  List<Formula> wanted() {
    return wanted;
  }

  /** What was begun and is wanted no more, by what is wanted now; it is forgotten here. */
  List<BegunGoal> wants(List<Formula> now) {
    wanted = List.copyOf(now);
    List<BegunGoal> unwanted = new ArrayList<>();
    begun
        .values()
        .removeIf(
            goal -> {
              boolean isUnwanted = !wanted.contains(goal.goal());
              if (isUnwanted) {
                unwanted.add(goal);
              }
              return isUnwanted;
            });
    return unwanted;
  }

  /** What is wanted and was not begun. */
  List<Formula> missing() {
    return wanted.stream().filter(goal -> !begun.containsKey(goal)).toList();
  }

  void begun(BegunGoal goal) {
    begun.put(goal.goal(), goal);
  }

  /** It could not be begun after all. */
  void forget(Formula goal) {
    begun.remove(goal);
  }

  Optional<BegunGoal> of(Formula goal) {
    return Optional.ofNullable(begun.get(goal));
  }

  List<String> ids() {
    return begun.values().stream().map(BegunGoal::id).toList();
  }

  /** Another word was heard, or none is to come: the former silence does not count. */
  void heard(Optional<Clock.Timer> next) {
    silence.ifPresent(Clock.Timer::cancel);
    silence = next;
  }
}
