/**
 * What readings mean in a situation: forms flow in, MAESTRO-SL messages and doubts flow out. Of
 * several readings the one with the fewest broken references counts; what stays open is asked, and
 * nothing is guessed (ADE, 4.2). Knows constructions, states and measures as a home's wording has
 * them, and no language.
 */
@NullMarked
package org.maestro.language.meaning;

import org.jspecify.annotations.NullMarked;
