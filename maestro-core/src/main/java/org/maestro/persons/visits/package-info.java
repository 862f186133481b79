/**
 * Where persons have gone from where, and how long ago, counted, and where somebody will go next by
 * that (ADE, 1; A2). Passages flow in, and into a log; predictions flow out. It does not know how
 * one finds out where somebody is.
 */
@NullMarked
package org.maestro.persons.visits;

import org.jspecify.annotations.NullMarked;
