/**
 * Where each of several persons probably is: a forward filter over the zones of a home and away
 * (ADE, 1; A2). Ways, time that passes and evidence flow in; probabilities flow out. Immutable, and
 * nothing but arithmetic: it knows no knowledge base, no words and no clock.
 */
@NullMarked
package org.maestro.persons.belief;

import org.jspecify.annotations.NullMarked;
