/**
 * Words as people say them: with fillers, broken off, corrected, misheard. Words flow in one by one
 * and may be taken back; a chart of what was meant to be said flows out, and what became of each
 * word (ADE, 4.2: robust to misheard and broken-off speech). Never leaves a word out that it does
 * not know.
 */
@NullMarked
package org.maestro.language.hearing;

import org.jspecify.annotations.NullMarked;
