/**
 * What steps of a home do, as plain cases: each with facts and bounds that it needs, facts that
 * hold afterwards, amounts that it adds to sums, and a price that is a number. A ground problem
 * flows in; cases, or a {@link org.maestro.planning.ground.GroundTask} of them, flow out, or the
 * sentence that says what cannot be told so. Alternatives, conditional effects and prices that
 * depend on numbers have become cases of their own. It solves nothing and writes nothing.
 */
@NullMarked
package org.maestro.planning.cases;

import org.jspecify.annotations.NullMarked;
