package org.maestro.coordination.achievement;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningResult.Obstacle;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * Members without which there seems to be no plan, and that were lost, or have described themselves
 * for the first time, moments ago only. Devices come back: their network does, or their power. So
 * no goal is given up for want of one before it was waited for a while, counted from then. The
 * coordinator's thread only.
 */
final class AwaitedMembers {
  private final Ports ports;
  private final Roster roster;
  private final ActiveGoals activeGoals;
  private final String goalId;
  private Set<String> awaited = Set.of();
  private List<Formula> wouldHelp = List.of();
  private Optional<Clock.Timer> end = Optional.empty();

  AwaitedMembers(Ports ports, Roster roster, ActiveGoals activeGoals, String goalId) {
    this.ports = ports;
    this.roster = roster;
    this.activeGoals = activeGoals;
    this.goalId = goalId;
  }

  /**
   * Members that are missed according to the explanation, or that may have what was looked for
   * everywhere else, and of which there was news so lately that they may be there soon.
   */
  Set<String> missed(PlanningResult result) {
    Set<String> missed = new TreeSet<>();
    if (result instanceof PlanningResult.Impossible impossible) {
      Set<String> expected = roster.expectedSince(ports.clock().now().minus(ports.comeback()));
      Snapshot now = ports.knowledge().snapshot();
      conditions(impossible.explanation())
          .forEach(
              condition ->
                  expected.stream()
                      .filter(
                          member -> isOf(condition, member) || mayBeWith(condition, member, now))
                      .forEach(missed::add));
    }
    return missed;
  }

  /** What was looked for everywhere else may be with one that is lost: a sentence for each. */
  List<String> perhapsWithTheLost(PlanningResult result) {
    Set<String> sentences = new LinkedHashSet<>();
    if (result instanceof PlanningResult.Impossible impossible) {
      Snapshot now = ports.knowledge().snapshot();
      Sentences words = new Sentences(ports.knowledge().home().vocabulary());
      conditions(impossible.explanation())
          .forEach(
              condition ->
                  roster.lost().stream()
                      .filter(member -> mayBeWith(condition, member, now))
                      .map(
                          member ->
                              "It may be that %s, which is not there (%s)."
                                  .formatted(
                                      words.fact(
                                          withValue((Formula.Atom) formula(condition), member)),
                                      roster.absence(member, ports.clock().now())))
                      .forEach(sentences::add));
    }
    return List.copyOf(sentences);
  }

  private static Stream<Obstacle> conditions(PlanningResult.Explanation explanation) {
    return explanation.obstacles().stream()
        .flatMap(
            obstacle ->
                Stream.concat(
                    Stream.of(obstacle),
                    obstacle.cures().stream().flatMap(cure -> cure.conditions().stream())));
  }

  private static boolean isOf(Obstacle condition, String member) {
    return condition.kind() == Obstacle.Kind.MEMBER && condition.condition().equals(member);
  }

  /** What it had when it was lost may be with it still. */
  private boolean mayBeWith(Obstacle condition, String member, Snapshot now) {
    return condition.kind() == Obstacle.Kind.EXCLUDED
        && formula(condition) instanceof Formula.Atom atom
        && ports
            .knowledge()
            .home()
            .vocabulary()
            .predicate(atom.predicate())
            .filter(PredicateDeclaration::functional)
            .filter(predicate -> mayBeValue(predicate, member, now))
            .isPresent()
        && now.truth(withValue(atom, member)) == Truth.UNKNOWN;
  }

  private static boolean mayBeValue(PredicateDeclaration predicate, String member, Snapshot now) {
    int last = predicate.parameters().size() - 1;
    return now.individuals(predicate.parameters().get(last).className().orElse(""))
        .contains(new Term.Name(member));
  }

  private static Formula.Atom withValue(Formula.Atom atom, String value) {
    List<Term> arguments = new ArrayList<>(atom.arguments());
    arguments.set(arguments.size() - 1, new Term.Name(value));
    return new Formula.Atom(atom.predicate(), arguments);
  }

  private Formula formula(Obstacle condition) {
    return SlParser.formula(condition.condition(), ports.knowledge().home().vocabulary()::isFluent);
  }

  /**
   * From now on it is waited.
   *
   * @param over called when that has been long enough
   * @return how long, at most
   */
  Duration await(Set<String> members, PlanningResult result, Runnable over) {
    awaited = members;
    wouldHelp =
        result instanceof PlanningResult.Impossible impossible
            ? conditions(impossible.explanation())
                .filter(AwaitedMembers::isOfTheWorld)
                .map(this::formula)
                .toList()
            : List.of();
    Duration limit =
        members.stream()
            .flatMap(member -> roster.expectedFrom(member).stream())
            .max(Duration::compareTo)
            .orElseThrow()
            .plus(ports.comeback())
            .minus(ports.clock().now());
    end =
        Optional.of(
            ports
                .clock()
                .schedule(limit, goalId, () -> ports.owner().execute(() -> activeGoals.run(over))));
    return limit;
  }

  private static boolean isOfTheWorld(Obstacle condition) {
    return condition.kind() != Obstacle.Kind.MEMBER && condition.kind() != Obstacle.Kind.STEP;
  }

  boolean isAny() {
    return !awaited.isEmpty();
  }

  /** Whether what was missing is so now, without anybody's help. */
  boolean isHelped() {
    Evaluation now = new Evaluation(ports.knowledge().snapshot());
    return wouldHelp.stream().anyMatch(formula -> now.truth(formula, Map.of()) == Truth.TRUE);
  }

  void forget() {
    awaited = Set.of();
    wouldHelp = List.of();
    end.ifPresent(Clock.Timer::cancel);
    end = Optional.empty();
  }
}
