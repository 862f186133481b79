package org.maestro.coordination.facts;

import org.maestro.knowledge.api.KnowledgeBase;

/**
 * The state of knowledge when a plan was looked at or begun. Changes are told one after the other,
 * and the coordinator may hear of them late: what was in the facts already is no news.
 *
 * @param version of the knowledge
 * @param facts what it showed, but for what steps were just changing
 */
public record KnowledgeVersion(long version, FactsMaskedByRunningSteps facts) {

  /** Whether the change was seen then. */
  public boolean has(KnowledgeBase.Change change, FactFilter changed) {
    return change.version() <= version && !facts.hides(changed);
  }
}
