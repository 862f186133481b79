/**
 * A planning task without variables: operators, conditions, numbers, states, and what follows from
 * them alone. Formulas and facts flow in; conditions that can be checked in a state flow out.
 */
@NullMarked
package org.maestro.planning.problem;

import org.jspecify.annotations.NullMarked;
