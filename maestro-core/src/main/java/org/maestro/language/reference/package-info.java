/**
 * What noun phrases refer to: forms and a situation flow in, references to things of the home flow
 * out (ADE, 4.2: the visual situation is asked while one listens). Never guesses: what several
 * things could be is told as open. Knows no verbs and no language.
 */
@NullMarked
package org.maestro.language.reference;

import org.jspecify.annotations.NullMarked;
