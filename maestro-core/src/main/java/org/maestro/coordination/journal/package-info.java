/**
 * What a journal's entries amount to: goals without an end and what they need to be taken up.
 * Entries flow in one by one; the shortest list that amounts to the same, and what is to be
 * recovered, flow out. It knows neither files nor who writes.
 */
@NullMarked
package org.maestro.coordination.journal;

import org.jspecify.annotations.NullMarked;
