package org.maestro.coordination.story;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.facts.Sensing;
import org.maestro.knowledge.api.MemberCondition;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.home.PrivateWords;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * Says what is known of a thing that a goal names: what members tell, and what the home states;
 * what is private stays out of stories.
 */
public final class KnownOf {
  private static final int MOST_FACTS = 6;
  private static final String POSITION = "position";
  private static final String POSE = "pose";

  private final Home home;
  private final List<String> known;
  private final Sentences sentences;
  private final ReadingRights readers;

  /**
   * @param known facts in MAESTRO-SL; what members are at is left out
   */
  KnownOf(Home home, List<String> known) {
    this.home = home;
    this.known = known;
    this.sentences = new Sentences(home.vocabulary());
    this.readers = PrivateWords.of(home).ofAnybody();
  }

  String sentences(String name) {
    List<String> told =
        known.stream()
            .filter(fact -> mentions(fact, name))
            .filter(fact -> !MemberCondition.isAllOf(List.of(fact)))
            .toList();
    List<String> all = Stream.concat(told.stream(), stated(name)).distinct().toList();
    List<String> facts =
        all.stream().filter(readers::mayReadFact).map(sentences::fact).limit(MOST_FACTS).toList();
    boolean isSomewhere = canBeSomewhere(name) && told.stream().noneMatch(f -> isPlace(f, name));
    String where = isSomewhere ? "Where " + name + " is, nobody knows." : "";
    if (facts.isEmpty() && !all.isEmpty()) {
      return ("What is known of " + name + " is private. " + where).strip();
    }
    if (facts.isEmpty()) {
      return where.isEmpty() ? "Of " + name + " nothing is known yet." : where;
    }
    return ("Known of " + name + ": " + String.join("; ", facts) + ". " + where).strip();
  }

  /** What the home says of it in words that goals use, in the order in which people read it. */
  private Stream<String> stated(String name) {
    Individual individual = individual(name);
    List<String> facts = new ArrayList<>();
    for (Map.Entry<String, List<Term>> property : individual.properties().entrySet()) {
      Optional<PredicateDeclaration> declared = home.vocabulary().predicate(property.getKey());
      for (Term value : declared.isPresent() ? property.getValue() : List.<Term>of()) {
        fact(declared.get(), new Term.Name(name), value).ifPresent(facts::add);
      }
    }
    return facts.stream().sorted(Comparator.comparing(sentences::fact));
  }

  /** Only what the home has is asked for. */
  private Individual individual(String name) {
    return Objects.requireNonNull(home.individuals().get(name));
  }

  private static Optional<String> fact(PredicateDeclaration declared, Term subject, Term value) {
    if (value instanceof Term.Number) {
      String text = "(= (%s %s) %s)";
      return Optional.of(
          text.formatted(declared.name(), SlPrinter.print(subject), SlPrinter.print(value)));
    }
    if (value instanceof Term.Truth truth) {
      return Optional.of(declared.name())
          .filter(predicate -> truth.value())
          .map(predicate -> "(%s %s)".formatted(predicate, SlPrinter.print(subject)));
    }
    return Optional.of(value)
        .filter(Term.Name.class::isInstance)
        .map(
            other ->
                "(%s %s %s)"
                    .formatted(declared.name(), SlPrinter.print(subject), SlPrinter.print(other)));
  }

  /** Whether it is of a kind that members look for, and the home does not say where it is. */
  private boolean canBeSomewhere(String name) {
    Individual individual = individual(name);
    return !individual.properties().containsKey(POSE)
        && soughtPlaces()
            .map(place -> place.parameters().get(0).className())
            .anyMatch(kind -> kind.isEmpty() || individual.classes().contains(kind.get()));
  }

  /** What tells where something is, and somebody can look for. */
  private Stream<PredicateDeclaration> soughtPlaces() {
    Set<String> sought =
        home.devices().values().stream()
            .flatMap(device -> device.features().stream())
            .flatMap(feature -> Sensing.names(feature.effect()).stream())
            .collect(Collectors.toSet());
    return places().filter(place -> sought.contains(place.name()));
  }

  private Stream<PredicateDeclaration> places() {
    return home.vocabulary().predicates().values().stream()
        .filter(declared -> declared.functional() && declared.observedWhen().isPresent())
        .filter(declared -> !declared.parameters().isEmpty());
  }

  private boolean isPlace(String fact, String name) {
    return SlParser.formula(fact, home.vocabulary()::isFluent) instanceof Formula.Atom atom
        && atom.arguments().indexOf(new Term.Name(name)) == 0
        && (atom.predicate().equals(POSITION)
            || places().anyMatch(place -> place.name().equals(atom.predicate())));
  }

  private static boolean mentions(String fact, String name) {
    return fact.contains(name) && words(fact).contains(name);
  }

  static Set<String> words(String fact) {
    return new HashSet<>(List.of(fact.replaceAll("[()]", " ").trim().split("\\s+")));
  }
}
