package org.maestro.knowledge.belief;

/**
 * All that is said of one predicate: an answer rests on it that looked for whom the predicate
 * holds.
 */
record Relation(String predicate) {}
