/**
 * What goals are worth at the moment (ADE, 4.1). Stakes, ends of goals, changes of knowledge and
 * what is left of plans flow in; grades flow out, by which goals go before others, and the numbers
 * that they come from. It knows nothing of what goals contend for, and decides nothing.
 */
@NullMarked
package org.maestro.coordination.worth;

import org.jspecify.annotations.NullMarked;
