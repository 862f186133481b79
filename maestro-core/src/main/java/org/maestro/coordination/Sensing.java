package org.maestro.coordination;

import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.maestro.knowledge.KnowledgeBase;
import org.maestro.knowledge.Snapshot;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.Step;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** What a feature's effect finds out. */
final class Sensing {

  private Sensing() {}

  static boolean isIn(Effect effect) {
    return any(effect, e -> e instanceof Effect.SenseAtom || e instanceof Effect.SenseNumber);
  }

  static boolean isOfAtoms(Effect effect) {
    return any(effect, Effect.SenseAtom.class::isInstance);
  }

  /** Names of the predicates and numbers that it senses. */
  static Set<String> names(Effect effect) {
    Set<String> names = new TreeSet<>();
    any(
        effect,
        part -> {
          if (part instanceof Effect.SenseAtom sense) {
            names.add(sense.atom().predicate());
          } else if (part instanceof Effect.SenseNumber sense) {
            names.add(sense.fluent().name());
          }
          return false;
        });
    return names;
  }

  /**
   * That nothing is known after the step of all that it was to find out; empty when anything is, or
   * when it was a search, of which it is counted elsewhere how often it was in vain.
   */
  static Optional<String> leftUnknown(Step step, KnowledgeBase knowledge) {
    Vocabulary vocabulary = knowledge.home().vocabulary();
    Effect effect = step.feature().effect();
    if (!isIn(effect) || !SearchLog.sensed(effect, vocabulary).isEmpty()) {
      return Optional.empty();
    }
    Map<String, Term> bindings = new TreeMap<>(step.bindings());
    bindings.put("self", new Term.Name(step.member()));
    Substitution substitution = new Substitution(bindings);
    Snapshot now = knowledge.snapshot();
    Sentences sentences = new Sentences(vocabulary);
    Set<String> unknown = new LinkedHashSet<>();
    boolean[] known = {false};
    any(
        effect,
        part -> {
          if (part instanceof Effect.SenseNumber sense) {
            Expression.Fluent fluent = substitution.apply(sense.fluent());
            known[0] |= now.number(fluent).isPresent();
            if (fluent.arguments().stream().allMatch(Term::isGround)) {
              unknown.add(sentences.quantity(fluent));
            }
          } else if (part instanceof Effect.SenseAtom sense) {
            Formula.Atom atom = substitution.apply(sense.atom());
            known[0] |= atom.isGround() && now.truth(atom) != Truth.UNKNOWN;
            if (atom.isGround()) {
              unknown.add("whether " + sentences.fact(atom));
            }
          }
          return false;
        });
    return known[0] || unknown.isEmpty()
        ? Optional.empty()
        : Optional.of("it does not tell " + String.join(", ", unknown));
  }

  private static boolean any(Effect effect, Predicate<Effect> wanted) {
    if (effect instanceof Effect.All all) {
      return all.effects().stream().anyMatch(part -> any(part, wanted));
    } else if (effect instanceof Effect.When when) {
      return any(when.effect(), wanted);
    } else if (effect instanceof Effect.Forall forall) {
      return any(forall.effect(), wanted);
    }
    return wanted.test(effect);
  }
}
