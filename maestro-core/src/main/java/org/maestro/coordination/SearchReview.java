package org.maestro.coordination;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.knowledge.Belief;
import org.maestro.knowledge.Snapshot;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.planning.Planner;
import org.maestro.planning.PlanningResult;
import org.maestro.planning.PlanningTask;
import org.maestro.planning.PricedFeature;
import org.maestro.planning.Step;
import org.maestro.planning.StepKey;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * Looks back on the searches of a goal that was not reached: what was looked at and by whom, what
 * was not, and why. Why not is found by asking the planner for a way to look there, with those who
 * are here, and with those who are lost. Immutable; computes on the caller's thread.
 */
final class SearchReview {
  private final Home home;
  private final Snapshot now;
  private final Planner planner;
  private final List<PricedFeature> features;
  private final Set<StepKey> barred;
  private final Set<String> absent;
  private final SearchLog log;
  private final Duration time;

  /**
   * @param features those of members that are here
   * @param absent members that are not here
   */
  SearchReview(
      Home home,
      Snapshot now,
      Planner planner,
      List<PricedFeature> features,
      Set<StepKey> barred,
      Set<String> absent,
      SearchLog log,
      Clock clock) {
    this.home = home;
    this.now = now;
    this.planner = planner;
    this.features = List.copyOf(features);
    this.barred = Set.copyOf(barred);
    this.absent = new TreeSet<>(absent);
    this.log = log;
    this.time = clock.now();
  }

  /** A report for each thing that the goal names and whose place nobody knows. */
  List<SearchReport> reports(Formula goal) {
    Set<String> predicates = new LinkedHashSet<>();
    for (Device device : home.devices().values()) {
      for (FeatureType feature : device.features()) {
        SearchLog.sensed(feature.effect(), home.vocabulary())
            .forEach(atom -> predicates.add(atom.predicate()));
      }
    }
    List<SearchReport> reports = new ArrayList<>();
    for (String predicate : predicates) {
      PredicateDeclaration declaration = home.vocabulary().predicate(predicate).orElseThrow();
      for (Term.Name thing : named(goal, declaration)) {
        if (now.value(predicate, List.of(thing)).isEmpty()) {
          report(declaration, thing).ifPresent(reports::add);
        }
      }
    }
    return reports;
  }

  private List<Term.Name> named(Formula goal, PredicateDeclaration declaration) {
    List<String> words =
        List.of(SlPrinter.print(goal).replaceAll("[()]", " ").trim().split("\\s+"));
    return now.individuals(declaration.parameters().get(0).className().orElse("")).stream()
        .filter(individual -> words.contains(individual.text()))
        .toList();
  }

  /** Empty when nobody looked and nobody could have: then there was no search. */
  private Optional<SearchReport> report(PredicateDeclaration declaration, Term.Name thing) {
    List<SearchReport.Look> looks = new ArrayList<>();
    List<SearchReport.Gap> gaps = new ArrayList<>();
    for (Term.Name place : places(declaration)) {
      Formula.Atom atom = new Formula.Atom(declaration.name(), List.of(thing, place));
      look(atom).ifPresent(looks::add);
      if (now.truth(atom) == Truth.UNKNOWN) {
        gaps.add(gap(atom));
      }
    }
    looks.sort(Comparator.comparing(SearchReport.Look::at));
    return looks.isEmpty() && gaps.isEmpty()
        ? Optional.empty()
        : Optional.of(new SearchReport(declaration.name(), thing.text(), looks, gaps));
  }

  /** Those with a floor; where none has, all that are no devices. */
  private List<Term.Name> places(PredicateDeclaration declaration) {
    List<Term.Name> all =
        new ArrayList<>(now.individuals(declaration.parameters().get(1).className().orElse("")));
    List<Term.Name> measured =
        all.stream()
            .filter(
                place -> now.number(new Expression.Fluent("floorArea", List.of(place))).isPresent())
            .toList();
    return measured.isEmpty()
        ? all.stream().filter(place -> !home.devices().containsKey(place.text())).toList()
        : measured;
  }

  /** One of this goal, or what is known of an earlier one. */
  private Optional<SearchReport.Look> look(Formula.Atom atom) {
    return log.latest(atom)
        .or(
            () ->
                now.truth(atom) == Truth.FALSE
                    ? now.belief(atom).map(belief -> look(atom, belief))
                    : Optional.empty());
  }

  private SearchReport.Look look(Formula.Atom atom, Belief belief) {
    Duration age = belief.age(now.at());
    return new SearchReport.Look(
        SearchLog.place(atom),
        belief.source().agent(),
        age.compareTo(time) > 0 ? Duration.ZERO : time.minus(age),
        belief.coveredShare());
  }

  private SearchReport.Gap gap(Formula.Atom atom) {
    String place = SearchLog.place(atom);
    PlanningResult result = planner.plan(lookingAt(atom, features));
    if (result instanceof PlanningResult.Found) {
      return new SearchReport.Gap(place, SearchReport.Reason.OF_NO_USE, List.of());
    }
    List<String> missed = missed(atom);
    if (!missed.isEmpty()) {
      return new SearchReport.Gap(place, SearchReport.Reason.MEMBERS_LOST, missed);
    }
    if (log.latest(atom).isPresent()) {
      return new SearchReport.Gap(place, SearchReport.Reason.LOOKED_IN_VAIN, List.of());
    }
    List<String> obstacles = obstacles(atom, result);
    return new SearchReport.Gap(
        place,
        obstacles.isEmpty() ? SearchReport.Reason.NOBODY_CAN : SearchReport.Reason.CONDITION,
        obstacles);
  }

  /** The lost members without whom nobody can look there, and with whom somebody could. */
  private List<String> missed(Formula.Atom atom) {
    List<PricedFeature> all = new ArrayList<>(features);
    for (String member : absent) {
      Optional.ofNullable(home.devices().get(member))
          .map(Device::features)
          .orElse(List.of())
          .forEach(type -> all.add(new PricedFeature(member, type, type.cost(), Map.of())));
    }
    if (all.size() == features.size()
        || !(planner.plan(lookingAt(atom, all)) instanceof PlanningResult.Found found)) {
      return List.of();
    }
    return found.plan().steps().stream()
        .map(Step::member)
        .filter(absent::contains)
        .distinct()
        .toList();
  }

  private static List<String> obstacles(Formula.Atom atom, PlanningResult result) {
    if (!(result instanceof PlanningResult.Impossible impossible)) {
      return List.of(((PlanningResult.GaveUp) result).reason());
    }
    String sought = SlPrinter.print(atom);
    return impossible.explanation().obstacles().stream()
        .filter(obstacle -> !obstacle.condition().contains(sought))
        .map(
            obstacle ->
                "%s needs %s; possible: %s"
                    .formatted(obstacle.neededBy(), obstacle.condition(), obstacle.possible()))
        .toList();
  }

  private PlanningTask lookingAt(Formula.Atom atom, List<PricedFeature> offered) {
    return new PlanningTask(home.vocabulary(), now, offered, atom, barred);
  }
}
