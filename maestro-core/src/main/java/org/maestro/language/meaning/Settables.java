package org.maestro.language.meaning;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.maestro.language.reference.Reference;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/** What features can set and bring about in a home. Not safe for threads. */
final class Settables {
  private static final String SELF = "self";

  private final Home home;
  private final Map<String, Set<Bringer>> bringing = new HashMap<>();
  private final Map<String, Set<Bringer>> ending = new HashMap<>();

  Settables(Home home) {
    this.home = home;
  }

  /** Whether a feature sets the number: of a device its own, of a place anybody's. */
  boolean maySet(PredicateDeclaration fluent, Reference whose) {
    if (whose instanceof Reference.Single single) {
      return maySet(fluent, single.term());
    } else if (whose instanceof Reference.Several several) {
      return several.terms().stream().allMatch(term -> maySet(fluent, term));
    } else if (whose instanceof Reference.Open open) {
      return open.candidates().stream().allMatch(term -> maySet(fluent, term));
    } else if (whose instanceof Reference.Either either) {
      return either.options().stream().allMatch(option -> maySet(fluent, option));
    }
    return home.devices().values().stream().anyMatch(device -> sets(device, fluent));
  }

  /** Of several only those of which it can be set. */
  Reference of(PredicateDeclaration fluent, Reference whose) {
    if (!(whose instanceof Reference.Several several)) {
      return whose;
    }
    List<Term> those = several.terms().stream().filter(term -> maySet(fluent, term)).toList();
    return those.isEmpty()
        ? whose
        : those.size() == 1 ? new Reference.Single(those.get(0)) : new Reference.Several(those);
  }

  private boolean maySet(PredicateDeclaration fluent, Term term) {
    Device device = term instanceof Term.Name name ? home.devices().get(name.text()) : null;
    return device == null
        ? home.devices().values().stream().anyMatch(any -> sets(any, fluent))
        : sets(device, fluent);
  }

  /**
   * Whether some device's features can bring it about; what is more than one atom or number is
   * taken to be possible.
   */
  boolean mayBringAbout(Formula goal) {
    if (goal instanceof Formula.Keep keep) {
      return mayBringAbout(keep.body());
    }
    boolean isWished = !(goal instanceof Formula.Not);
    Formula inner = goal instanceof Formula.Not not ? not.operand() : goal;
    return !(inner instanceof Formula.Atom atom)
        || (isWished ? bringing() : ending())
            .getOrDefault(atom.predicate(), Set.of()).stream()
                .anyMatch(bringer -> bringer.mayBring(atom));
  }

  /**
   * Whether it is a number of a place, and who sets such numbers does so for other places only, as
   * the home says: the thermostats of other rooms.
   */
  boolean isOutOfReach(Formula goal) {
    if (!(goal instanceof Formula.Comparison comparison)
        || !(comparison.left() instanceof Expression.Fluent fluent)
        || fluent.arguments().size() != 1
        || !(fluent.arguments().get(0) instanceof Term.Name place)
        || home.devices().containsKey(place.text())) {
      return false;
    }
    return home.devices().values().stream()
        .flatMap(
            device ->
                device.features().stream()
                    .flatMap(
                        feature ->
                            assigned(feature.effect(), fluent.name())
                                .map(where -> isElsewhere(device, feature, where, place))))
        .reduce((one, other) -> one && other)
        .orElse(false);
  }

  /** The variables of whose number an effect is one. */
  private static Stream<Term> assigned(Effect effect, String fluent) {
    if (effect instanceof Effect.All all) {
      return all.effects().stream().flatMap(part -> assigned(part, fluent));
    }
    return effect instanceof Effect.Change change
            && change.assignment() == Effect.Assignment.ASSIGN
            && change.fluent().name().equals(fluent)
            && change.fluent().arguments().size() == 1
        ? Stream.of(change.fluent().arguments().get(0))
        : Stream.of();
  }

  private static boolean isElsewhere(
      Device device, FeatureType feature, Term where, Term.Name place) {
    List<Formula> conditions =
        feature.precondition() instanceof Formula.And and
            ? and.operands()
            : List.of(feature.precondition());
    return conditions.stream()
        .filter(Formula.Atom.class::isInstance)
        .map(Formula.Atom.class::cast)
        .filter(atom -> atom.arguments().equals(List.of(new Term.Variable(SELF), where)))
        .map(atom -> device.individual().properties().getOrDefault(atom.predicate(), List.of()))
        .anyMatch(stated -> !stated.isEmpty() && !stated.contains(place));
  }

  /**
   * Who brings an atom about.
   *
   * @param place of which argument it is the device itself; -1 when it is of none
   */
  private record Bringer(String device, int place) {
    boolean mayBring(Formula.Atom atom) {
      return place < 0
          || place < atom.arguments().size()
              && (!(atom.arguments().get(place) instanceof Term.Name name)
                  || name.text().equals(device));
    }
  }

  private Map<String, Set<Bringer>> bringing() {
    if (bringing.isEmpty()) {
      index();
    }
    return bringing;
  }

  private Map<String, Set<Bringer>> ending() {
    if (bringing.isEmpty()) {
      index();
    }
    return ending;
  }

  private void index() {
    for (Device device : home.devices().values()) {
      device.features().forEach(feature -> index(feature.effect(), device.individual().name()));
    }
  }

  private void index(Effect effect, String device) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> index(part, device));
    } else if (effect instanceof Effect.When when) {
      index(when.effect(), device);
    } else if (effect instanceof Effect.Forall forall) {
      index(forall.effect(), device);
    } else if (effect instanceof Effect.Add add) {
      enter(bringing, add.atom(), device);
    } else if (effect instanceof Effect.Delete delete) {
      enter(ending, delete.atom(), device);
    }
  }

  private static void enter(Map<String, Set<Bringer>> index, Formula.Atom atom, String device) {
    int place = atom.arguments().indexOf(new Term.Variable(SELF));
    index
        .computeIfAbsent(atom.predicate(), predicate -> new HashSet<>())
        .add(new Bringer(place < 0 ? "" : device, place));
  }

  private static boolean sets(Device device, PredicateDeclaration fluent) {
    return device.features().stream().map(FeatureType::effect).anyMatch(e -> sets(e, fluent));
  }

  private static boolean sets(Effect effect, PredicateDeclaration fluent) {
    if (effect instanceof Effect.All all) {
      return all.effects().stream().anyMatch(part -> sets(part, fluent));
    } else if (effect instanceof Effect.When when) {
      return sets(when.effect(), fluent);
    }
    return effect instanceof Effect.Change change
        && change.assignment() == Effect.Assignment.ASSIGN
        && change.fluent().name().equals(fluent.name());
  }
}
