package org.maestro.language.meaning;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.language.grammar.Form;
import org.maestro.language.reference.Reference;
import org.maestro.language.reference.Relations;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.wording.StateWord;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/** What things are said to be, or are to become. Bound to one reading. */
final class States {
  private final Situation situation;
  private final References references;

  States(Situation situation, References references) {
    this.situation = situation;
    this.references = references;
  }

  /** What is so when the thing is in the state, or at the place. */
  Optional<Formula> holding(Form thing, Form state) {
    if (thing.is("nobody")) {
      return holding(Form.leaf("somebody"), state).map(Formula.Not::new);
    }
    if (state.is("not")) {
      return holding(thing, state.part(0)).map(Formula.Not::new);
    }
    if (state.is("and")) {
      return both(holding(thing, state.part(0)), holding(thing, state.part(1)));
    }
    return state.is("state")
        ? inState(thing, state, word -> Optional.of(word.holdsWhen()))
        : at(thing, state);
  }

  /** The goal that the thing come into the state. */
  Optional<Formula> bringing(Form thing, Form state) {
    if (state.is("not")) {
      return inState(thing, state.part(0), word -> Optional.of(new Formula.Not(word.holdsWhen())));
    }
    if (state.is("and")) {
      return both(bringing(thing, state.part(0)), bringing(thing, state.part(1)));
    }
    return inState(thing, state, StateWord::broughtAboutBy);
  }

  private static Optional<Formula> both(Optional<Formula> one, Optional<Formula> other) {
    return one.flatMap(
        first -> other.map(second -> References.conjunction(List.of(first, second))));
  }

  /** How a state's word becomes a formula over {@code ?it}. */
  private interface Spelled {
    Optional<Formula> of(StateWord word);
  }

  private Optional<Formula> inState(Form thing, Form state, Spelled spelled) {
    Optional<Reference> broken = Optional.empty();
    List<Formula> ofEachKind = new ArrayList<>();
    for (StateWord word : situation.home().wording().states()) {
      if (!state.parts().contains(Form.leaf(word.name()))) {
        continue;
      }
      Optional<Formula> formula = spelled.of(word);
      if (formula.isEmpty()) {
        continue;
      }
      Reference reference =
          thing.is("place")
              ? place(thing.part(0), word)
              : references.phrases().resolve(thing, word.of());
      if (reference instanceof Reference.Mistyped || reference instanceof Reference.Unsaid) {
        continue;
      }
      if (reference instanceof Reference.None) {
        broken = broken.isPresent() ? broken : Optional.of(reference);
        continue;
      }
      Optional<Formula> said =
          references.over(
              reference,
              term -> Optional.of(References.substituted(formula.get(), Map.of("it", term))));
      if (!isOfAnyKind(thing) || said.isEmpty()) {
        return said;
      }
      ofEachKind.add(said.get());
    }
    if (!ofEachKind.isEmpty()) {
      return Optional.of(
          ofEachKind.size() == 1
              ? ofEachKind.get(0)
              : isEverything(thing)
                  ? References.conjunction(ofEachKind)
                  : new Formula.Or(ofEachKind));
    }
    if (broken.isPresent()) {
      references.over(broken.get(), term -> Optional.empty());
    } else {
      references.die();
    }
    return Optional.empty();
  }

  /** Whether it is said of whatever may be so: of lamps, and of all else that may be on. */
  private static boolean isOfAnyKind(Form thing) {
    return isEverything(thing)
        || thing.is("any")
        || thing.is("np") && thing.text(0).equals("a") && isOfAnyKind(thing.part(1))
        || (thing.is("at") || thing.is("placed")) && isOfAnyKind(thing.part(0));
  }

  private static boolean isEverything(Form thing) {
    return thing.is("everything") || thing.is("placed") && isEverything(thing.part(0));
  }

  private Reference place(Form where, StateWord word) {
    if (where.is("_") || where.is("here")) {
      return situation
          .here()
          .filter(here -> references.phrases().relations().isA(new Term.Name(here), word.of()))
          .<Reference>map(here -> new Reference.Single(new Term.Name(here)))
          .orElse(where.is("_") ? new Reference.Mistyped(where) : new Reference.None(where));
    }
    return where.is("rel")
        ? references.phrases().resolve(where.part(1), word.of())
        : new Reference.Mistyped(where);
  }

  /** What is so when the thing is at the place. */
  Optional<Formula> at(Form thing, Form where) {
    if (where.is("here") || where.is("there") || where.is("home")) {
      Optional<Term> place =
          where.is("here")
              ? situation.here().map(Term.Name::new)
              : where.is("there") ? references.phrases().lastPlace() : Optional.empty();
      return place.flatMap(term -> related(thing, places(), new Reference.Single(term)));
    }
    if (!where.is("rel")) {
      references.die();
      return Optional.empty();
    }
    return related(thing, predicates(where.part(0)), where.part(1));
  }

  List<PredicateDeclaration> predicates(Form preposition) {
    return preposition.parts().stream()
        .map(part -> situation.home().vocabulary().predicate(part.head()))
        .flatMap(Optional::stream)
        .filter(predicate -> predicate.parameters().size() == 2)
        .toList();
  }

  List<PredicateDeclaration> places() {
    return references.phrases().relations().ofPlaces();
  }

  private Optional<Formula> related(Form thing, List<PredicateDeclaration> predicates, Form other) {
    Optional<Reference> broken = Optional.empty();
    for (PredicateDeclaration predicate : predicates) {
      Reference whose = references.phrases().resolve(thing, Relations.typeOf(predicate, 0));
      Reference where = references.phrases().resolve(other, Relations.typeOf(predicate, 1));
      if (isMissing(whose) || isMissing(where)) {
        continue;
      }
      if (whose instanceof Reference.None || where instanceof Reference.None) {
        broken = Optional.of(whose instanceof Reference.None ? whose : where);
        continue;
      }
      return both(predicate, whose, where);
    }
    if (broken.isPresent()) {
      references.over(broken.get(), term -> Optional.empty());
    } else {
      references.die();
    }
    return Optional.empty();
  }

  private Optional<Formula> related(
      Form thing, List<PredicateDeclaration> predicates, Reference where) {
    for (PredicateDeclaration predicate : predicates) {
      Reference whose = references.phrases().resolve(thing, Relations.typeOf(predicate, 0));
      boolean fits =
          where instanceof Reference.Single single
              && references.phrases().relations().fits(predicate, 1, single.term());
      if (fits && !isMissing(whose)) {
        return both(predicate, whose, where);
      }
    }
    references.die();
    return Optional.empty();
  }

  private static boolean isMissing(Reference reference) {
    return reference instanceof Reference.Mistyped || reference instanceof Reference.Unsaid;
  }

  private Optional<Formula> both(PredicateDeclaration predicate, Reference whose, Reference where) {
    return references.over(
        whose,
        thing ->
            references.over(
                where,
                place -> Optional.of(new Formula.Atom(predicate.name(), List.of(thing, place)))));
  }
}
