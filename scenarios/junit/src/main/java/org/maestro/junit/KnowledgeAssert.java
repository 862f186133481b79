package org.maestro.junit;

import java.util.stream.Collectors;
import org.assertj.core.api.AbstractAssert;
import org.maestro.knowledge.Question;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Truth;

/** Assertions on what the platform knows now. Failures show what it knows. */
public final class KnowledgeAssert extends AbstractAssert<KnowledgeAssert, KnowledgeBase> {

  KnowledgeAssert(KnowledgeBase actual) {
    super(actual, KnowledgeAssert.class);
  }

  /**
   * @param formula in MAESTRO-SL; free variables are existential
   */
  public KnowledgeAssert knows(String formula) {
    return is(formula, Truth.TRUE);
  }

  /** Known not to hold, which is more than not known to hold. */
  public KnowledgeAssert excludes(String formula) {
    return is(formula, Truth.FALSE);
  }

  public KnowledgeAssert doesNotKnow(String formula) {
    return is(formula, Truth.UNKNOWN);
  }

  private KnowledgeAssert is(String formula, Truth expected) {
    isNotNull();
    Snapshot snapshot = actual.snapshot();
    Truth truth = new Question(snapshot).queryIf(parsed(formula));
    if (truth != expected) {
      failWithMessage(
          "Expected %s to be %s, but it is %s. Known is:%n%s",
          formula,
          expected,
          truth,
          snapshot.beliefs().stream().map(Belief::fact).collect(Collectors.joining("\n")));
    }
    return this;
  }

  private Formula parsed(String formula) {
    return SlParser.formula(formula, actual.home().vocabulary()::isFluent);
  }
}
