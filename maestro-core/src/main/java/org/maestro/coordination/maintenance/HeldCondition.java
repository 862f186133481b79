package org.maestro.coordination.maintenance;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.coordination.facts.CausalLinks;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Change;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/**
 * The condition that a held goal wants to be so.
 *
 * @param body what is to be reached
 * @param closed the same for any values of its free variables
 */
record HeldCondition(Formula body, Formula closed) {

  static HeldCondition of(Formula.Keep goal) {
    Formula body = goal.body();
    List<TypedVariable> free =
        FreeVariables.of(body).stream()
            .map(name -> new TypedVariable(name, Optional.empty()))
            .toList();
    return new HeldCondition(body, free.isEmpty() ? body : new Formula.Exists(free, body));
  }

  boolean isSo(KnowledgeBase knowledge) {
    return new Evaluation(knowledge.snapshot()).truth(closed, Map.of()) == Truth.TRUE;
  }

  /** What the changes would spoil of it. */
  Optional<Formula> brokenBy(List<Change> changes, Snapshot now, Vocabulary vocabulary) {
    CausalLinks causalLinks = new CausalLinks(vocabulary);
    causalLinks.addAll(closed, Map.of());
    return causalLinks.brokenBy(changes, now);
  }
}
