package org.maestro.language.meaning;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.language.reference.Reference;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Effect;
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
