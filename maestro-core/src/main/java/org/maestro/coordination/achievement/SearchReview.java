package org.maestro.coordination.achievement;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.api.SearchReport;
import org.maestro.coordination.facts.Relevance;
import org.maestro.coordination.facts.Sensing;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.planning.api.Planner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningResult.Obstacle;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.api.Unavailable;
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
public final class SearchReview {
  private final Home home;
  private final Snapshot now;
  private final Planner planner;
  private final List<PricedFeature> features;
  private final Set<StepKey> barred;
  private final List<Unavailable> unavailable;
  private final SearchLog log;
  private final Duration time;

  /**
   * What nobody was asked for, since it does nothing for the goal, may serve to look all the same:
   * it counts with the price that its description says.
   *
   * @param offered by members that are here
   */
  static SearchReview of(
      Formula goal,
      Ports ports,
      Roster roster,
      List<PricedFeature> offered,
      Set<StepKey> barred,
      SearchLog log) {
    Home home = ports.knowledge().home();
    Map<String, List<String>> asked = Relevance.candidates(goal, home);
    List<PricedFeature> features = new ArrayList<>(offered);
    List<Unavailable> unavailable = new ArrayList<>();
    for (Device device : home.devices().values()) {
      List<PricedFeature> described =
          device.features().stream()
              .map(type -> new PricedFeature(device.id(), type, type.cost(), Map.of()))
              .toList();
      if (!roster.isPresent(device.id())) {
        String why = roster.absence(device.id());
        described.forEach(feature -> unavailable.add(new Unavailable(feature, why)));
      } else {
        described.stream()
            .filter(f -> !asked.getOrDefault(f.member(), List.of()).contains(f.type().name()))
            .filter(f -> offered.stream().noneMatch(o -> isSame(f, o)))
            .forEach(features::add);
      }
    }
    return new SearchReview(
        home,
        ports.knowledge().snapshot(),
        ports.planner(),
        features,
        barred,
        unavailable,
        log,
        ports.clock());
  }

  private static boolean isSame(PricedFeature one, PricedFeature other) {
    return one.member().equals(other.member()) && one.type().name().equals(other.type().name());
  }

  /**
   * @param features those of members that are here
   * @param unavailable those of members that are not
   */
  public SearchReview(
      Home home,
      Snapshot now,
      Planner planner,
      List<PricedFeature> features,
      Set<StepKey> barred,
      List<Unavailable> unavailable,
      SearchLog log,
      Clock clock) {
    this.home = home;
    this.now = now;
    this.planner = planner;
    this.features = List.copyOf(features);
    this.barred = Set.copyOf(barred);
    this.unavailable = List.copyOf(unavailable);
    this.log = log;
    this.time = clock.now();
  }

  /** A report for each thing that the goal names and whose place nobody knows. */
  public List<SearchReport> reports(Formula goal) {
    Set<String> predicates = new LinkedHashSet<>();
    for (Device device : home.devices().values()) {
      for (FeatureType feature : device.features()) {
        Sensing.sought(feature.effect(), home.vocabulary())
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
    if (log.latest(atom).isPresent()) {
      return new SearchReport.Gap(place, SearchReport.Reason.LOOKED_IN_VAIN, List.of());
    }
    PlanningResult result = planner.plan(lookingAt(atom));
    if (!(result instanceof PlanningResult.Impossible impossible)) {
      return new SearchReport.Gap(
          place,
          result instanceof PlanningResult.Found
              ? SearchReport.Reason.OF_NO_USE
              : SearchReport.Reason.NOT_DECIDED,
          List.of());
    }
    String sought = SlPrinter.print(atom);
    List<Obstacle> obstacles =
        impossible.explanation().obstacles().stream()
            .filter(obstacle -> !obstacle.condition().contains(sought))
            .toList();
    return new SearchReport.Gap(place, reason(obstacles), obstacles);
  }

  private static SearchReport.Reason reason(List<Obstacle> obstacles) {
    if (obstacles.isEmpty()) {
      return SearchReport.Reason.NOBODY_CAN;
    }
    return obstacles.stream().anyMatch(obstacle -> obstacle.kind() == Obstacle.Kind.MEMBER)
        ? SearchReport.Reason.MEMBERS_LOST
        : SearchReport.Reason.CONDITION;
  }

  private PlanningTask lookingAt(Formula.Atom atom) {
    return new PlanningTask(
            home.vocabulary(),
            now,
            features.stream().filter(feature -> Sensing.helpsToLook(feature.type(), atom)).toList(),
            atom,
            barred)
        .withUnavailable(
            unavailable.stream()
                .filter(missed -> Sensing.helpsToLook(missed.feature().type(), atom))
                .toList(),
            Map.of());
  }
}
