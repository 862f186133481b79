package org.maestro.coordination.achievement;

import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.planning.api.Step;

/**
 * The end of a step, and what came of it.
 *
 * @param calledOff by the coordinator itself, so that its failure says nothing
 * @param factsBefore on which it rested, before its report taught anything
 * @param begun what was known when it was begun
 * @param change what its report taught
 */
record StepEnd(
    Step step,
    ActionDispatcher.Report report,
    boolean calledOff,
    String factsBefore,
    Snapshot begun,
    KnowledgeBase.Change change) {}
