package org.maestro.coordination.composites;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.maestro.coordination.api.Sentences;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.planning.api.Step;
import org.maestro.sl.Change;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * What a script is to have brought about when it is done. A script says nothing of itself: what its
 * own steps have reported and what was seen has to show it.
 */
final class PromisedEffect {
  /** A level that was set is told with a rounding. */
  private static final double SHARE_OFF = 0.01;

  private final KnowledgeBase knowledge;
  private final List<Change> changes;

  /** To be made before the script begins, as an effect may speak of what was so before. */
  PromisedEffect(Step step, KnowledgeBase knowledge) {
    this.knowledge = knowledge;
    this.changes =
        new Evaluation(knowledge.snapshot()).changes(step.feature().effect(), step.values());
  }

  /** What of it is not known to be so, as the end of a sentence; empty when all is. */
  Optional<String> missing() {
    Snapshot now = knowledge.snapshot();
    Sentences sentences = new Sentences(knowledge.home().vocabulary());
    List<String> missing =
        changes.stream()
            .filter(change -> !isSo(change, now))
            .map(change -> inWords(change, sentences))
            .toList();
    return missing.isEmpty()
        ? Optional.empty()
        : Optional.of(
            missing.stream().collect(Collectors.joining(" and ", "it is not known that ", "")));
  }

  private static boolean isSo(Change change, Snapshot now) {
    if (change instanceof Change.OfTruth truth) {
      Truth known = now.truth(truth.atom());
      return truth.value() ? known == Truth.TRUE : known != Truth.TRUE;
    }
    Change.OfNumber number = (Change.OfNumber) change;
    OptionalDouble known = now.number(number.fluent());
    return number.value().isEmpty()
        || known.isPresent()
            && Math.abs(known.getAsDouble() - number.value().getAsDouble())
                <= SHARE_OFF * Math.max(1, Math.abs(number.value().getAsDouble()));
  }

  private static String inWords(Change change, Sentences sentences) {
    if (change instanceof Change.OfTruth truth) {
      return sentences.fact(truth.value() ? truth.atom() : new Formula.Not(truth.atom()));
    }
    Change.OfNumber number = (Change.OfNumber) change;
    return SlPrinter.print(
        new Formula.Comparison(
            Formula.Relation.EQUAL,
            number.fluent(),
            new Expression.OfTerm(new Term.Number(number.value().orElseThrow()))));
  }
}
