package org.maestro.coordination.achievement;

import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.facts.Sensing;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Step;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** A success that tells nothing of what it was to find out. */
final class EmptyResult {
  private EmptyResult() {}

  /**
   * What is not known after the step, in words; absent when anything of it is, or when it was a
   * search, of which it is counted elsewhere how often it was in vain.
   */
  static Optional<String> of(Step step, KnowledgeBase knowledge) {
    Vocabulary vocabulary = knowledge.home().vocabulary();
    Effect effect = step.feature().effect();
    if (!Sensing.isIn(effect) || !Sensing.sought(effect, vocabulary).isEmpty()) {
      return Optional.empty();
    }
    Substitution substitution = new Substitution(step.values());
    Snapshot now = knowledge.snapshot();
    Sentences sentences = new Sentences(vocabulary);
    Set<String> unknown = new LinkedHashSet<>();
    boolean[] known = {false};
    Sensing.any(
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
}
