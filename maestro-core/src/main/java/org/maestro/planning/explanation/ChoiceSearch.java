package org.maestro.planning.explanation;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.planning.api.Choice;
import org.maestro.planning.api.Choice.Other;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Planner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.problem.EffectSignature;
import org.maestro.planning.problem.Quantity;

/**
 * Finds out why a step was given to its member: plans again without that member's part, then also
 * without the one that takes its place, and so on, until nobody is left who could.
 */
public final class ChoiceSearch {
  private static final int MOST_OTHERS = 6;

  private final Planner planner;

  public ChoiceSearch(Planner planner) {
    this.planner = planner;
  }

  /**
   * The choice of a step's member.
   *
   * @param task for which the plan was made
   */
  public Choice of(PlanningTask task, Plan plan, Step step) {
    Set<EffectSignature> wanted = EffectSignature.of(step.feature().effect());
    Set<String> open = new LinkedHashSet<>();
    for (PricedFeature feature : task.features()) {
      if (bringsAbout(feature.type(), wanted)) {
        open.add(feature.member());
      }
    }
    Set<String> barred = new LinkedHashSet<>();
    List<Other> others = new ArrayList<>();
    String out = step.member();
    while (others.size() < MOST_OTHERS) {
      open.remove(out);
      barred.add(out);
      if (open.isEmpty()) {
        break;
      }
      PlanningResult result =
          planner.plan(
              task.withFeatures(
                  task.features().stream()
                      .filter(f -> !barred.contains(f.member()) || !bringsAbout(f.type(), wanted))
                      .toList()));
      if (!(result instanceof PlanningResult.Found found)) {
        open.forEach(member -> others.add(impossible(member, result)));
        break;
      }
      Optional<String> next = newcomer(found.plan(), plan, open, wanted);
      if (next.isEmpty()) {
        break;
      }
      out = next.get();
      others.add(
          new Other(
              out,
              OptionalDouble.of(Quantity.rounded(found.plan().cost() - plan.cost())),
              found.plan().steps().stream().anyMatch(s -> !s.exactPrice()),
              List.of()));
    }
    return new Choice(step, plan.cost(), List.copyOf(others));
  }

  private static Other impossible(String member, PlanningResult result) {
    return new Other(
        member,
        OptionalDouble.empty(),
        false,
        result instanceof PlanningResult.Impossible impossible
            ? impossible.explanation().obstacles()
            : List.of());
  }

  /** Who does a step of the kind in the new plan that it did not do in the old one. */
  private static Optional<String> newcomer(
      Plan now, Plan before, Set<String> open, Set<EffectSignature> wanted) {
    Set<StepKey> old = new LinkedHashSet<>();
    before.steps().forEach(step -> old.add(step.key()));
    return now.steps().stream()
        .filter(step -> open.contains(step.member()))
        .filter(step -> !old.contains(step.key()))
        .filter(step -> bringsAbout(step.feature(), wanted))
        .map(Step::member)
        .findFirst();
  }

  /** Any of it: a lamp and a shutter are in each other's place for the light, not for a level. */
  private static boolean bringsAbout(FeatureType feature, Set<EffectSignature> wanted) {
    return EffectSignature.of(feature.effect()).stream().anyMatch(wanted::contains);
  }
}
