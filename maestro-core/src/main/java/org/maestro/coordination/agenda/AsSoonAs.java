package org.maestro.coordination.agenda;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.knowledge.Instances;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;

/**
 * Begins its goal as soon as a condition is known to hold, at once if it does so already, for the
 * first choice of individuals, and ends with it.
 */
final class AsSoonAs implements Vigil {
  /** Where what is begun is noted, before it is begun. */
  private static final String GOAL = "2";

  /** Who has come back after a restart tells of itself within this time. */
  private static final Duration TELLING = Duration.ofSeconds(1);

  private final Entry entry;
  private final Formula condition;
  private final Formula goal;
  private boolean isWatching;

  AsSoonAs(Entry entry, Formula condition, Formula goal) {
    this.entry = entry;
    this.condition = condition;
    this.goal = goal;
  }

  @Override
  public void start() {
    await();
    look();
  }

  private void await() {
    isWatching = true;
    entry.awaits(SlPrinter.print(condition) + " to become so");
  }

  private void look() {
    new Instances(condition, entry.known())
        .all().entrySet().stream().findFirst().ifPresent(this::begin);
  }

  private void begin(Map.Entry<Formula, Substitution> first) {
    Formula wanted = first.getValue().apply(goal);
    entry.note(GOAL, SlPrinter.print(wanted));
    begin(wanted, "because " + SlPrinter.print(first.getKey()) + " is so");
  }

  private void begin(Formula wanted, String because) {
    isWatching = false;
    String id = entry.begin(wanted, because, why -> entry.end(GoalState.FAILED, why, "nobody"));
    entry.follow(id, "");
  }

  /** What was so while there was no platform, and is so still, comes late and is not lost. */
  @Override
  public void takeUp() {
    Optional<String> begun = entry.begunBefore();
    if (begun.isPresent() && entry.unborn().isEmpty()) {
      entry.followAgain(begun.get(), "");
      return;
    }
    Optional<Formula> wanted =
        begun
            .flatMap(id -> entry.texts(GOAL).getOrDefault(GOAL, Optional.empty()))
            .map(text -> SlParser.formula(text, entry.vocabulary()::isFluent));
    if (wanted.isPresent()) {
      begin(wanted.get(), "because " + SlPrinter.print(condition) + " was so");
      return;
    }
    entry.awaits(SlPrinter.print(condition) + " to become so");
    entry.at(entry.now().plus(TELLING), this::start);
  }

  @Override
  public void knowledgeChanged(FactFilter changed) {
    if (isWatching && FactFilter.ofReading(condition, entry.vocabulary()).isConcernedBy(changed)) {
      look();
    }
  }
}
