/**
 * Solves ground tasks: a first plan at once, then cheaper ones, with a proven lower bound, until
 * the cheapest is proven or time is over. A {@link org.maestro.planning.ground.GroundTask} flows
 * in, a {@link org.maestro.planning.search.Solution} flows out. "Optimal" and "unsolvable" are only
 * said with proof. It knows nothing of where tasks come from.
 */
@NullMarked
package org.maestro.planning.search;

import org.jspecify.annotations.NullMarked;
