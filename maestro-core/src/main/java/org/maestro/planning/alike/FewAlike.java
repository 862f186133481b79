package org.maestro.planning.alike;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.Objective;
import org.maestro.planning.api.PlanningResult.Found;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Leaves;
import org.maestro.sl.Term;

/**
 * A task with few of the members that are alike: of which the same is known, and which offer the
 * same at the same price. Of robots that somebody has to find first each would do; with all of them
 * a building has as many ways as robots times places.
 */
public final class FewAlike {
  /** A plan may use one beside the other, and have one to spare. */
  private static final int KEPT = 3;

  private record Offer(FeatureType type, Price price) {}

  private final PlanningTask task;
  private final List<Set<String>> groups;

  private FewAlike(PlanningTask task, List<Set<String>> groups) {
    this.task = task;
    this.groups = groups;
  }

  /**
   * The task with few of each kind; empty when there are no more anyway, or time counts, in which
   * many are sooner done than few.
   */
  public static Optional<FewAlike> of(PlanningTask task) {
    if (task.objective() != Objective.CHEAPEST) {
      return Optional.empty();
    }
    List<Set<String>> groups = groups(task);
    Set<Term.Name> spare = new HashSet<>();
    groups.forEach(group -> group.stream().skip(KEPT).map(Term.Name::new).forEach(spare::add));
    if (spare.isEmpty()) {
      return Optional.empty();
    }
    PlanningTask fewer =
        task.withFacts(new FactsWithout(task.facts(), spare))
            .withFeatures(
                task.features().stream()
                    .filter(feature -> !spare.contains(new Term.Name(feature.member())))
                    .toList());
    return Optional.of(new FewAlike(fewer, groups));
  }

  public PlanningTask task() {
    return task;
  }

  /**
   * Whether what was found with few will do: the plan has to find something out, and then it is not
   * called the cheapest, or no plan of that cost has to do with any of them, and so with others.
   */
  public boolean suffices(Found found) {
    return !found.plan().searches().isEmpty()
        || groups.stream().allMatch(group -> Collections.disjoint(group, found.contenders()));
  }

  /** What was found with few, told of all. */
  public Found withOthers(Found found) {
    Set<String> contenders = new LinkedHashSet<>(found.contenders());
    for (Set<String> group : groups) {
      if (group.stream().anyMatch(found.contenders()::contains)) {
        contenders.addAll(group);
      }
    }
    return new Found(found.plan(), found.atLeast(), contenders, found.rivals());
  }

  private static List<Set<String>> groups(PlanningTask task) {
    Map<String, List<Offer>> offers = new LinkedHashMap<>();
    Set<Term> named = named(task);
    for (PricedFeature feature : task.features()) {
      offers
          .computeIfAbsent(feature.member(), absent -> new ArrayList<>())
          .add(new Offer(feature.type(), feature.price()));
      if (!feature.exact().isEmpty()) {
        named.add(new Term.Name(feature.member()));
        feature.exact().keySet().forEach(values -> named.addAll(values.values()));
      }
    }
    List<Term.Name> members =
        offers.keySet().stream().map(Term.Name::new).filter(name -> !named.contains(name)).toList();
    return task.facts().alike(members).stream()
        .filter(alike -> alike.size() > KEPT)
        .flatMap(alike -> withTheSame(alike, offers).stream())
        .toList();
  }

  private static Collection<Set<String>> withTheSame(
      List<Term.Name> alike, Map<String, List<Offer>> offers) {
    Map<List<Offer>, Set<String>> byOffers = new LinkedHashMap<>();
    for (Term.Name name : alike) {
      byOffers
          .computeIfAbsent(
              Objects.requireNonNull(offers.get(name.text())), absent -> new LinkedHashSet<>())
          .add(name.text());
    }
    return byOffers.values();
  }

  /** Of which the task speaks by name. */
  private static Set<Term> named(PlanningTask task) {
    Set<Term> named = new HashSet<>();
    Leaves.of(
        task.goal(),
        atom -> named.addAll(atom.arguments()),
        fluent -> named.addAll(fluent.arguments()));
    for (StepKey key : task.barred()) {
      named.add(new Term.Name(key.member()));
      named.addAll(key.bindings().values());
    }
    return named;
  }
}
