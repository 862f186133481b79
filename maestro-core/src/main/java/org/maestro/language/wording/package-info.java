/**
 * Sentences of the platform's own, in a language's words: questions back, and what was not
 * understood. Doubts and a situation flow in, sentences without ids flow out. The phrases stand in
 * the grammar's file, the names in the home.
 */
@NullMarked
package org.maestro.language.wording;

import org.jspecify.annotations.NullMarked;
