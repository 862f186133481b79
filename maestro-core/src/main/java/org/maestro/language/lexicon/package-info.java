/**
 * The words of a home in a language: what its things, classes, numbers and states are called, and
 * the rules that its constructions are. A home's wording and a grammar flow in, entries and rules
 * for the chart flow out. Knows no world: who is called so, not where he is.
 */
@NullMarked
package org.maestro.language.lexicon;

import org.jspecify.annotations.NullMarked;
