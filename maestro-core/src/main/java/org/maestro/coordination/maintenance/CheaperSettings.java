package org.maestro.coordination.maintenance;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.allocation.PlanPurpose;
import org.maestro.coordination.allocation.PlanningRound;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.facts.ProgressedState;
import org.maestro.coordination.facts.Settings;
import org.maestro.coordination.facts.Tightened;
import org.maestro.coordination.lessons.Experience;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * Looks whether a held goal could be held at less cost: the cheapest plan from the present without
 * the goal's own settings, made with a margin, against what these settings cost. Only what saves a
 * twentieth or more is worth a change.
 */
final class CheaperSettings {
  private static final double WORTH_WHILE = 0.05;

  private final String goalId;
  private final Formula goal;
  private final Ports ports;
  private final ExactPrices exactPrices;
  private final Experience experience;
  private final OwnSettings settings;

  CheaperSettings(
      String goalId,
      Formula goal,
      Ports ports,
      ExactPrices exactPrices,
      Experience experience,
      OwnSettings settings) {
    this.goalId = goalId;
    this.goal = goal;
    this.ports = ports;
    this.exactPrices = exactPrices;
    this.experience = experience;
    this.settings = settings;
  }

  /**
   * Settings that would be cheaper.
   *
   * @param goal that these settings be as they would be in the cheaper plan, and the goal holds
   * @param cost of these settings
   * @param instead of this
   */
  record Cheaper(Formula goal, double cost, double instead) {}

  /** Answers on the coordinator's thread. */
  void consider(Consumer<Optional<Cheaper>> then) {
    Snapshot now = ports.knowledge().snapshot();
    Facts without = settings.without(now, vocabulary());
    Formula tight =
        Tightened.of(
            goal,
            name ->
                vocabulary().predicate(name).filter(PredicateDeclaration::observable).isPresent());
    new PlanningRound(
            ports,
            new Roster(),
            exactPrices,
            experience,
            new PlanningRound.Subject(goalId, tight, Optional.empty(), PlanPurpose.REACH),
            Map.of(),
            Set.of(),
            () -> without,
            round -> {
              round.tender().reject();
              then.accept(cheaper(round, without));
            })
        .start();
  }

  private Optional<Cheaper> cheaper(PlanningRound.Ended round, Facts without) {
    if (!(round.result() instanceof PlanningResult.Found found)) {
      return Optional.empty();
    }
    PlanningTask anything =
        new PlanningTask(
            vocabulary(), without, round.features(), new Formula.And(List.of()), Set.of());
    double present =
        ports.planner().revalidate(anything, settings.steps()).map(Plan::cost).orElse(0.0);
    return found.plan().cost() < present * (1 - WORTH_WHILE)
        ? Optional.of(new Cheaper(settled(found.plan(), without), found.plan().cost(), present))
        : Optional.empty();
  }

  /** The goal, and all settings as they are after the plan. */
  private Formula settled(Plan plan, Facts without) {
    Set<Expression.Fluent> fluents = new LinkedHashSet<>();
    settings.steps().forEach(step -> fluents.addAll(Settings.assigned(step)));
    Facts facts = without;
    for (Step step : plan.steps()) {
      fluents.addAll(Settings.assigned(step));
      facts = ProgressedState.of(facts, vocabulary(), step);
    }
    List<Formula> parts = new ArrayList<>(List.of(goal));
    for (Expression.Fluent fluent : fluents) {
      OptionalDouble value = facts.number(fluent);
      if (value.isPresent()) {
        parts.add(
            new Formula.Comparison(
                Formula.Relation.EQUAL,
                fluent,
                new Expression.OfTerm(new Term.Number(value.getAsDouble()))));
      }
    }
    return new Formula.And(parts);
  }

  private Vocabulary vocabulary() {
    return ports.knowledge().home().vocabulary();
  }
}
