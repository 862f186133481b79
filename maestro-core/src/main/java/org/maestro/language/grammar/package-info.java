/**
 * The grammar of a language of people: rules with what they mean, and how verbs and nouns change
 * their form. A data file flows in, a {@link org.maestro.language.grammar.Grammar} out, to which
 * constructions add rules of theirs. What is meant is a tree of {@link
 * org.maestro.language.grammar.Form}s, in which no world has been looked at. Knows no word of any
 * language.
 */
@NullMarked
package org.maestro.language.grammar;

import org.jspecify.annotations.NullMarked;
