/**
 * A goal that is to be reached once: planned, its steps done, their results learnt from, seen,
 * ended; or that is one call of one member. Knowledge, reports and the turns of other goals flow
 * in; orders, plans made again and an outcome flow out. It knows nothing of goals that are held.
 */
@NullMarked
package org.maestro.coordination.achievement;

import org.jspecify.annotations.NullMarked;
