package org.maestro.coordination.pursuit;

import org.maestro.coordination.api.Crew;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.planning.api.Step;

/**
 * The end of a step, and what came of it.
 *
 * @param calledOff by the coordinator itself, so that its failure says nothing
 * @param factsBefore on which it rested, before its report taught anything
 * @param change what its report taught
 */
record StepEnd(
    Step step,
    Crew.Report report,
    boolean calledOff,
    String factsBefore,
    KnowledgeBase.Change change) {}
