package org.maestro.coordination;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.knowledge.Belief;
import org.maestro.knowledge.Snapshot;
import org.maestro.knowledge.Source;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.PricedFeature;
import org.maestro.sl.Effect;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/**
 * What still has to be seen before a goal may be called reached: the things of those goal atoms
 * that are only expected, though an observation of positions could decide them. For planning,
 * "seen" is a synthetic predicate that every sensing of the thing brings about.
 */
final class Confirmation {
  private static final String SEEN = "seen%";
  private static final String POSITION = "position";

  private final SortedSet<String> things;

  private Confirmation(SortedSet<String> things) {
    this.things = things;
  }

  static Optional<Confirmation> needed(
      Formula goal, Map<String, Term> binding, Snapshot snapshot, Vocabulary vocabulary) {
    SortedSet<String> things = new TreeSet<>();
    collect(new Substitution(binding).apply(goal), snapshot, vocabulary, things);
    return things.isEmpty() ? Optional.empty() : Optional.of(new Confirmation(things));
  }

  private static void collect(
      Formula formula, Snapshot snapshot, Vocabulary vocabulary, SortedSet<String> things) {
    if (formula instanceof Formula.And and) {
      and.operands().forEach(operand -> collect(operand, snapshot, vocabulary, things));
    } else if (formula instanceof Formula.Or or) {
      or.operands().stream()
          .filter(operand -> new Evaluation(snapshot).truth(operand, Map.of()) == Truth.TRUE)
          .findFirst()
          .ifPresent(operand -> collect(operand, snapshot, vocabulary, things));
    } else if (formula instanceof Formula.Atom atom
        && atom.isGround()
        && derivation(atom, vocabulary).isPresent()) {
      collect(derivation(atom, vocabulary).get(), snapshot, vocabulary, things);
    } else if (formula instanceof Formula.Atom atom
        && atom.isGround()
        && vocabulary
            .predicate(atom.predicate())
            .flatMap(PredicateDeclaration::observedWhen)
            .isPresent()
        && snapshot.belief(atom).filter(Confirmation::onlyExpected).isPresent()) {
      for (Term argument : atom.arguments()) {
        if (argument instanceof Term.Name name && !isSeen(name, snapshot)) {
          things.add(name.text());
        }
      }
    }
  }

  /** What a derived atom says in the words that it is derived from. */
  private static Optional<Formula> derivation(Formula.Atom atom, Vocabulary vocabulary) {
    return vocabulary
        .predicate(atom.predicate())
        .filter(declared -> declared.parameters().size() == atom.arguments().size())
        .flatMap(
            declared -> {
              Map<String, Term> bindings = new TreeMap<>();
              for (int i = 0; i < atom.arguments().size(); i++) {
                bindings.put(declared.parameters().get(i).name(), atom.arguments().get(i));
              }
              return declared.derivedWhen().map(new Substitution(bindings)::apply);
            });
  }

  private static boolean onlyExpected(Belief belief) {
    return belief.source().kind() == Source.Kind.EXPECTED;
  }

  private static boolean isSeen(Term.Name thing, Snapshot snapshot) {
    return snapshot
        .value(POSITION, List.of(thing))
        .flatMap(value -> snapshot.belief(new Formula.Atom(POSITION, List.of(thing, value))))
        .filter(belief -> !onlyExpected(belief))
        .isPresent();
  }

  SortedSet<String> things() {
    return things;
  }

  /** The goal, and to have seen the things of which it speaks. */
  Formula goal(Formula original) {
    List<Formula> parts = new ArrayList<>();
    parts.add(original);
    things.forEach(thing -> parts.add(new Formula.Atom(SEEN, List.of(new Term.Name(thing)))));
    return new Formula.And(parts);
  }

  static Vocabulary extend(Vocabulary vocabulary) {
    Map<String, PredicateDeclaration> predicates = new TreeMap<>(vocabulary.predicates());
    predicates.put(
        SEEN,
        new PredicateDeclaration(
            SEEN,
            SEEN,
            "has been seen",
            List.of(new TypedVariable("x", Optional.empty())),
            false,
            false,
            false,
            false,
            Optional.<Duration>empty(),
            Map.of(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty()));
    return new Vocabulary(vocabulary.classes(), predicates, vocabulary.features());
  }

  static PricedFeature extend(PricedFeature priced) {
    FeatureType type = priced.type();
    List<Effect> effects = new ArrayList<>();
    effects.add(type.effect());
    addSeen(type.effect(), effects);
    if (effects.size() == 1) {
      return priced;
    }
    return new PricedFeature(
        priced.member(), type.withEffect(new Effect.All(effects)), priced.price(), priced.exact());
  }

  private static void addSeen(Effect effect, List<Effect> effects) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(e -> addSeen(e, effects));
    } else if (effect instanceof Effect.SenseAtom sense) {
      effects.add(new Effect.Add(new Formula.Atom(SEEN, sense.atom().arguments().subList(0, 1))));
    }
  }
}
