/**
 * What the words of a vocabulary and of a home are called in the languages of people: names,
 * adjectives, prepositions, measures, states and constructions, as its Turtle says them (ADE, 4.2).
 * A graph flows in, a {@link org.maestro.ontology.wording.Wording} out. Knows no language's
 * grammar.
 */
@NullMarked
package org.maestro.ontology.wording;

import org.jspecify.annotations.NullMarked;
