/**
 * Goals that are bound to a time or an event: what waits for it, and begins another goal then or
 * ends it. Times of the clock, changes of knowledge and ends of goals flow in; goals to be begun
 * and to be cancelled flow out. It knows neither plans nor what the goals that it begins are for.
 */
@NullMarked
package org.maestro.coordination.agenda;

import org.jspecify.annotations.NullMarked;
