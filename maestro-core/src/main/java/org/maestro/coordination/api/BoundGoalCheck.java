package org.maestro.coordination.api;

import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.StatementCheck;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.NumberVariables;
import org.maestro.sl.Occasion;
import org.maestro.sl.SlPrinter;

/** Refuses goals bound to a time or an event that could not be begun then, or never ended. */
final class BoundGoalCheck {
  private final StatementCheck conditions;

  BoundGoalCheck(Home home) {
    this.conditions = new StatementCheck(home, "The condition");
  }

  /**
   * @param unbound looks at a goal that is not bound, with the variables for which there will be
   *     something when it begins
   * @throws InvalidGoalException for the first that is wrong
   */
  void check(Formula.Bound bound, BiConsumer<Formula, Set<String>> unbound) {
    check(bound, Optional.empty(), unbound);
  }

  /**
   * @param given empty: no event is around it, and what it leaves open may be anything
   */
  private void check(
      Formula.Bound bound, Optional<Set<String>> given, BiConsumer<Formula, Set<String>> unbound) {
    Set<String> variables = new LinkedHashSet<>(given.orElse(Set.of()));
    boolean isEvent = bound.occasion() instanceof Occasion.Event;
    if (bound.occasion() instanceof Occasion.Event event) {
      check(event.condition());
      variables.addAll(FreeVariables.of(event.condition()));
    }
    if (bound instanceof Formula.Upon && isRepeated(bound.occasion()) && isEndless(bound.goal())) {
      throw new InvalidGoalException(
          "What begins again and again has to end; write (until \"23:00\" %s), or another end."
              .formatted(SlPrinter.print(bound.goal())));
    }
    Optional<Set<String>> inside =
        bound instanceof Formula.Upon && isEvent ? Optional.of(variables) : given;
    if (bound.goal() instanceof Formula.Bound inner) {
      check(inner, inside, unbound);
      return;
    }
    inside.ifPresent(known -> checkOpen(bound.goal(), known));
    unbound.accept(bound.goal(), inside.orElse(Set.of()));
  }

  private void check(Formula condition) {
    conditions
        .fault(condition)
        .or(
            () ->
                NumberVariables.of(condition).stream()
                    .findFirst()
                    .map(
                        open ->
                            "The condition leaves the number ?%s open; compare with a number."
                                .formatted(open)))
        .ifPresent(
            sentence -> {
              throw new InvalidGoalException(sentence);
            });
  }

  private static void checkOpen(Formula goal, Set<String> known) {
    FreeVariables.of(goal).stream()
        .filter(open -> !known.contains(open))
        .findFirst()
        .ifPresent(
            open -> {
              throw new InvalidGoalException(
                  "The condition says nothing of ?%s, which the goal has; write a name in its place."
                      .formatted(open));
            });
  }

  private static boolean isRepeated(Occasion occasion) {
    return occasion instanceof Occasion.Event event && event.again()
        || occasion instanceof Occasion.At at && at.again();
  }

  /** Whether it goes on until somebody cancels it. */
  private static boolean isEndless(Formula goal) {
    return goal instanceof Formula.Keep
        || goal instanceof Formula.Upon upon
            && (isRepeated(upon.occasion()) || isEndless(upon.goal()));
  }
}
