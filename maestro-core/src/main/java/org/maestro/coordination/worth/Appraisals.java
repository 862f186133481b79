package org.maestro.coordination.worth;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import java.util.function.Function;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.api.Stakes;
import org.maestro.coordination.api.Worth;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Evaluation;

/**
 * The worth of each goal whose requester says what it brings, looked at anew when its benefit, its
 * chance or what is left of its plan changes, and when its growing urgency takes it to another
 * grade: one event of the clock for each goal. The coordinator's thread only.
 */
public final class Appraisals {
  private final Ports ports;
  private final Function<String, Optional<? extends Progress>> progress;
  private final BiConsumer<String, GoalPriority> ranked;
  private final PastOutcomes past = new PastOutcomes();
  private final Map<String, Weighed> goals = new LinkedHashMap<>();

  private static final class Weighed {
    private final Stakes stakes;
    private final Optional<Duration> deadline;
    private final String shape;
    private final FactFilter interest;
    private final GoalPriority plain;
    private int grade;
    private Optional<Clock.Timer> next = Optional.empty();

    Weighed(GoalRequest request, Stakes stakes, GoalPriority plain, Ports ports) {
      this.stakes = stakes;
      this.deadline = request.deadline();
      this.shape = GoalShape.of(request.goal(), ports.knowledge().home());
      this.interest = new FactFilter(ports.knowledge().home().vocabulary());
      this.interest.add(stakes.benefit());
      this.plain = plain;
      this.grade = plain.grade();
    }
  }

  /**
   * @param progress of goals that are pursued, by their ids
   * @param ranked told each time that a goal is of another grade
   */
  public Appraisals(
      Ports ports,
      Function<String, Optional<? extends Progress>> progress,
      BiConsumer<String, GoalPriority> ranked) {
    this.ports = ports;
    this.progress = progress;
    this.ranked = ranked;
  }

  /** A goal is pursued from now on. */
  public void enter(String id, GoalRequest request, GoalPriority standing) {
    request
        .stakes()
        .ifPresent(
            stakes -> {
              goals.put(id, new Weighed(request, stakes, standing, ports));
              reappraise(id);
            });
  }

  /** A goal is over, of whatever worth. */
  public void ended(GoalRequest request, GoalOutcome outcome) {
    Optional.ofNullable(goals.remove(outcome.id()))
        .flatMap(goal -> goal.next)
        .ifPresent(Clock.Timer::cancel);
    String shape = GoalShape.of(request.goal(), ports.knowledge().home());
    if (past.add(shape, outcome)) {
      List.copyOf(goals.entrySet()).stream()
          .filter(goal -> goal.getValue().shape.equals(shape))
          .forEach(goal -> reappraise(goal.getKey()));
    }
  }

  /**
   * A plan was taken for a goal.
   *
   * @param isFirst it is for all of the goal, from where it began
   */
  public void planned(String id, boolean isFirst) {
    String whole = GoalId.whole(id);
    Weighed goal = goals.get(whole);
    if (goal != null) {
      if (isFirst && whole.equals(id)) {
        left(id).ifPresent(cost -> past.planned(goal.shape, cost));
      }
      reappraise(whole);
    }
  }

  /** Some of what was left of a goal's plan is done. */
  public void advanced(String id) {
    reappraise(GoalId.whole(id));
  }

  public void knowledgeChanged(FactFilter changed) {
    List.copyOf(goals.entrySet()).stream()
        .filter(goal -> goal.getValue().interest.isConcernedBy(changed))
        .forEach(goal -> reappraise(goal.getKey()));
  }

  public boolean isWeighed(String id) {
    return goals.containsKey(GoalId.whole(id));
  }

  /** What a goal is worth now; empty when nobody says what it is worth. */
  public Optional<Worth> find(String id) {
    String whole = GoalId.whole(id);
    return Optional.ofNullable(goals.get(whole)).map(goal -> worth(whole, goal));
  }

  /** The standing, with the grade that the goal has now. */
  public GoalPriority graded(String id, GoalPriority standing) {
    return Optional.ofNullable(goals.get(GoalId.whole(id)))
        .map(goal -> standing.graded(goal.grade))
        .orElse(standing);
  }

  /** The worth of both goals, as the end of a sentence. */
  public String comparison(String first, String second) {
    return " (its u·g is %s, this one's %s)".formatted(inWords(first), inWords(second));
  }

  private String inWords(String id) {
    OptionalDouble priority =
        find(id).map(Worth::priority).orElse(OptionalDouble.of(GoalPriority.UNWEIGHED_WORTH));
    return priority.isPresent() ? Sentences.number(priority.getAsDouble()) : "not known";
  }

  private Worth worth(String id, Weighed goal) {
    Stakes stakes = goal.stakes;
    Duration now = ports.clock().now();
    Duration since = progress.apply(id).map(Progress::pursuedSince).orElse(now);
    return new Worth(
        past.chance(goal.shape, stakes.chance()),
        past.tried(goal.shape),
        new Evaluation(ports.knowledge().snapshot()).number(stakes.benefit(), Map.of()),
        left(id).orElseGet(() -> past.meanCost(goal.shape)),
        now.minus(since),
        stakes.allowed().or(() -> goal.deadline.map(deadline -> deadline.minus(since))),
        stakes.urgencyFrom(),
        stakes.urgencyTo());
  }

  private OptionalDouble left(String id) {
    return progress.apply(id).map(Progress::remainingCost).orElseGet(OptionalDouble::empty);
  }

  private void reappraise(String id) {
    Weighed goal = goals.get(id);
    if (goal == null) {
      return;
    }
    goal.next.ifPresent(Clock.Timer::cancel);
    Worth worth = worth(id, goal);
    goal.next = worth.nextGradeAt().map(at -> lookAt(id, at.minus(worth.elapsed())));
    if (worth.grade() != goal.grade) {
      goal.grade = worth.grade();
      ranked.accept(id, goal.plain.graded(goal.grade));
    }
  }

  /** The clock's thread only hands over. */
  private Clock.Timer lookAt(String id, Duration delay) {
    return ports.clock().schedule(delay, id, () -> ports.owner().execute(() -> reappraise(id)));
  }
}
