package org.maestro.language.meaning;

import java.util.List;
import org.maestro.language.reference.Reference;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Effect;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/** Which numbers somebody can set, by what features are for. Immutable. */
final class Settables {
  private static final String SELF = "self";

  private final Home home;

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
        || home.devices().values().stream()
            .anyMatch(
                device ->
                    device.features().stream()
                        .map(FeatureType::effect)
                        .anyMatch(effect -> brings(effect, device, atom, isWished)));
  }

  private static boolean brings(Effect effect, Device device, Formula.Atom atom, boolean added) {
    if (effect instanceof Effect.All all) {
      return all.effects().stream().anyMatch(part -> brings(part, device, atom, added));
    } else if (effect instanceof Effect.When when) {
      return brings(when.effect(), device, atom, added);
    } else if (effect instanceof Effect.Forall forall) {
      return brings(forall.effect(), device, atom, added);
    } else if (effect instanceof Effect.Add add) {
      return added && isAbout(add.atom(), device, atom);
    }
    return !added && effect instanceof Effect.Delete delete && isAbout(delete.atom(), device, atom);
  }

  private static boolean isAbout(Formula.Atom effect, Device device, Formula.Atom atom) {
    if (!effect.predicate().equals(atom.predicate())
        || effect.arguments().size() != atom.arguments().size()) {
      return false;
    }
    for (int i = 0; i < atom.arguments().size(); i++) {
      boolean isOwn =
          effect.arguments().get(i) instanceof Term.Variable variable
              && variable.name().equals(SELF);
      if (isOwn
          && atom.arguments().get(i) instanceof Term.Name name
          && !name.text().equals(device.individual().name())) {
        return false;
      }
    }
    return true;
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
