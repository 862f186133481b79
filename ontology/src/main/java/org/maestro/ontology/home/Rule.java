package org.maestro.ontology.home;

import org.maestro.sl.Formula;

/**
 * A rule of a home: what begins by itself in it, at a time or whenever something happens, as long
 * as a platform runs.
 *
 * @param name local name, unique among the words, things and scripts of the home; the id of the
 *     rule among goals
 * @param goal begins other goals
 */
public record Rule(String name, String label, Formula.Bound goal) {}
