package org.maestro.coordination.agenda;

import java.time.Duration;
import java.util.Optional;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.knowledge.Instances;
import org.maestro.sl.Formula;
import org.maestro.sl.Occasion;
import org.maestro.sl.SlPrinter;

/** Begins its goal at once, and ends it at a time, or when a condition is known to hold. */
final class UntilThen implements Vigil {
  private final Entry entry;
  private final Formula.Until until;
  private final Due times;

  UntilThen(Entry entry, Formula.Until until) {
    this.entry = entry;
    this.until = until;
    this.times = new Due(until.occasion(), entry);
  }

  @Override
  public void start() {
    Optional<Duration> due = due();
    if (!isEvent() && due.isEmpty()) {
      entry.end(GoalState.FAILED, "That time was over when it was stated.", "nobody");
    } else if (isSo()) {
      entry.end(GoalState.FAILED, "It is so already that " + end(due) + ".", "nobody");
    } else {
      due.ifPresent(times::note);
      String id =
          entry.begin(
              until.goal(), "until " + end(due), why -> entry.end(GoalState.FAILED, why, "nobody"));
      await(id, due);
    }
  }

  private void await(String id, Optional<Duration> due) {
    entry.follow(id, ", until " + end(due));
    endAt(id, due);
  }

  private void endAt(String id, Optional<Duration> due) {
    due.ifPresent(moment -> entry.at(moment, () -> ends(id, end(due))));
  }

  private Optional<Duration> due() {
    return isEvent() ? Optional.empty() : times.noted().or(() -> times.after(entry.statedAt()));
  }

  private boolean isEvent() {
    return until.occasion() instanceof Occasion.Event;
  }

  private boolean isSo() {
    return until.occasion() instanceof Occasion.Event event
        && !new Instances(event.condition(), entry.known()).all().isEmpty();
  }

  private String end(Optional<Duration> due) {
    return until.occasion() instanceof Occasion.Event event
        ? SlPrinter.print(event.condition())
        : entry.inWords(due.orElseThrow());
  }

  @Override
  public void takeUp() {
    Optional<Duration> due = due();
    Optional<String> begun = entry.begunBefore().filter(id -> entry.unborn().isEmpty());
    if (begun.isEmpty() && due.filter(times::isMissed).isEmpty()) {
      start();
    } else if (due.filter(times::isMissed).isPresent()) {
      String end = end(due);
      begun.ifPresent(id -> entry.followAgain(id, ", until " + end));
      entry.missed("the end at " + end);
      entry.end(
          GoalState.FAILED,
          "It was to end at %s, when no platform ran; it ends now.".formatted(end),
          entry.id());
    } else {
      entry.followAgain(begun.get(), ", until " + end(due));
      endAt(begun.get(), due);
      endIfSo();
    }
  }

  @Override
  public void knowledgeChanged(FactFilter changed) {
    if (until.occasion() instanceof Occasion.Event event
        && FactFilter.ofReading(event.condition(), entry.vocabulary()).isConcernedBy(changed)) {
      endIfSo();
    }
  }

  private void endIfSo() {
    if (isSo()) {
      entry.followed().ifPresent(id -> ends(id, end(Optional.empty())));
    }
  }

  private void ends(String id, String end) {
    String kept = "It was kept until " + end + ".";
    String who = entry.id() + ", since it was wanted until " + end;
    if (entry.isHolding(id)) {
      entry.tell(StoryEntry.Kind.HELD, kept);
      entry.end(GoalState.ACHIEVED, kept, who);
    } else if (isReached()) {
      entry.end(GoalState.ACHIEVED, "It was so when it ended, at or by " + end + ".", who);
    } else {
      entry.end(GoalState.FAILED, "It was not so when it ended, at or by " + end + ".", who);
    }
  }

  /** What is wanted once may come about by what ends it, before who pursues it hears of that. */
  private boolean isReached() {
    Formula wanted = until.goal();
    while (wanted instanceof Formula.Upon upon && isOnce(upon.occasion())) {
      wanted = upon.goal();
    }
    return !(wanted instanceof Formula.Keep || wanted instanceof Formula.Bound)
        && !new Instances(wanted, entry.known()).all().isEmpty();
  }

  private static boolean isOnce(Occasion occasion) {
    return !(occasion instanceof Occasion.Event
        || occasion instanceof Occasion.At at && at.again());
  }
}
