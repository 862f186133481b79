package org.maestro.coordination.api;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.home.NamedPoints;
import org.maestro.ontology.home.Script;
import org.maestro.ontology.home.StatementCheck;
import org.maestro.ontology.validation.Nearest;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.NumberVariables;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * Refuses goals that speak of what neither home nor vocabulary know, before anybody is asked for
 * anything.
 */
public final class GoalCheck {
  private final Home home;
  private final StatementCheck statements;
  private final StatementCheck benefits;

  /** For goals in this home, also with points that it does not know yet. */
  public GoalCheck(Home home) {
    this.home = home;
    this.statements = new StatementCheck(home, "The goal");
    this.benefits = new StatementCheck(home, "The benefit");
  }

  /**
   * Looks at every word of a goal, and of what it is said to bring.
   *
   * @throws InvalidGoalException for the first that is wrong
   */
  public void check(GoalRequest request) {
    Optional<GoalCheck> withItsPoints = withPointsOf(request.goal());
    if (withItsPoints.isPresent()) {
      withItsPoints.get().check(request);
      return;
    }
    if (request.goal() instanceof Formula.Bound bound) {
      new BoundGoalCheck(home).check(bound, this::checkUnbound);
    } else {
      checkUnbound(request.goal(), Set.of());
    }
    request.stakes().map(Stakes::benefit).ifPresent(this::checkBenefit);
  }

  /**
   * @param given variables for which there will be something when it begins
   */
  private void checkUnbound(Formula goal, Set<String> given) {
    Optional<Script> script = script(goal);
    if (script.isPresent()) {
      check(script.get(), ((Formula.Atom) goal).arguments(), given);
    } else {
      refuse(unknownName(goal));
      check(goal);
    }
  }

  /** The same where the points are, too, that the goal names; empty when they are here. */
  private Optional<GoalCheck> withPointsOf(Formula goal) {
    NamedPoints points = NamedPoints.of(goal);
    refuse(points.objection(home).map(found -> found.sentence("The goal")));
    Home with = points.in(home);
    return with.equals(home) ? Optional.empty() : Optional.of(new GoalCheck(with));
  }

  private static void refuse(Optional<String> fault) {
    fault.ifPresent(
        sentence -> {
          throw new InvalidGoalException(sentence);
        });
  }

  private Optional<Script> script(Formula goal) {
    return goal instanceof Formula.Atom atom
        ? Optional.ofNullable(home.scripts().get(atom.predicate()))
        : Optional.empty();
  }

  /** Who writes a goal of one name may mean a script, where there are any. */
  private Optional<String> unknownName(Formula goal) {
    if (!(goal instanceof Formula.Atom atom)
        || home.scripts().isEmpty()
        || home.vocabulary().classes().containsKey(atom.predicate())
        || Nearest.to(atom.predicate(), home.vocabulary().predicates().keySet()).isPresent()) {
      return Optional.empty();
    }
    String cure =
        Nearest.to(atom.predicate(), home.scripts().keySet())
            .flatMap(name -> Optional.ofNullable(home.scripts().get(name)))
            .map(meant -> "write %s, if that is meant".formatted(meant.form()))
            .orElseGet(
                () ->
                    "there are the scripts %s, and ./maestro words lists the predicates"
                        .formatted(String.join(", ", home.scripts().keySet())));
    return Optional.of(
        "The goal names neither a predicate nor a script by %s; %s."
            .formatted(atom.predicate(), cure));
  }

  private void check(Script script, List<Term> arguments, Set<String> given) {
    if (arguments.size() != script.parameters().size()) {
      throw new InvalidGoalException(
          "The script %s takes %d values, not %d; write %s."
              .formatted(
                  script.name(), script.parameters().size(), arguments.size(), script.form()));
    }
    for (int i = 0; i < arguments.size(); i++) {
      TypedVariable parameter = script.parameters().get(i);
      Term argument = arguments.get(i);
      String wanted = parameter.className().orElse("");
      Optional<Individual> thing =
          argument instanceof Term.Name name
              ? Optional.ofNullable(home.individuals().get(name.text()))
              : Optional.empty();
      boolean isOfClass = thing.filter(one -> one.classes().contains(wanted)).isPresent();
      boolean isGiven = argument instanceof Term.Variable open && given.contains(open.name());
      if (home.vocabulary().classes().containsKey(wanted) && !isOfClass && !isGiven) {
        throw new InvalidGoalException(
            "%s is no %s of this home, as ?%s of %s is to be; write another."
                .formatted(SlPrinter.print(argument), wanted, parameter.name(), script.name()));
      }
    }
  }

  private void checkBenefit(Expression benefit) {
    refuse(
        benefits
            .fault(benefit)
            .or(
                () ->
                    FreeVariables.of(benefit).stream()
                        .findFirst()
                        .map(
                            open ->
                                "The benefit leaves ?%s open; write a name in its place."
                                    .formatted(open))));
  }

  /**
   * Looks at every word of a goal.
   *
   * @throws InvalidGoalException for the first that is wrong
   */
  public void check(Formula goal) {
    Optional<GoalCheck> withItsPoints = withPointsOf(goal);
    if (withItsPoints.isPresent()) {
      withItsPoints.get().check(goal);
      return;
    }
    script(goal)
        .ifPresent(
            script -> {
              throw new InvalidGoalException(
                  "%s is a script, whose plans are made as it goes on; state it as a goal."
                      .formatted(script.name()));
            });
    if (goal instanceof Formula.Bound) {
      throw new InvalidGoalException(
          "A goal that is bound to a time or an event has no plan before it begins; state it as a"
              + " goal.");
    }
    refuse(statements.fault(goal));
    Set<String> open = NumberVariables.of(goal);
    if (!open.isEmpty()) {
      throw new InvalidGoalException(
          "The goal leaves the number ?%s open; write one in its place."
              .formatted(open.iterator().next()));
    }
  }
}
