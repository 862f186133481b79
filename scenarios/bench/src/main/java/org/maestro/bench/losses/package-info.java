/**
 * The recovery after a loss: a process killed or frozen, a host cut off or slow, while a goal is
 * pursued on hosts of their own. A loss flows in; in which time the goal was reached, and that no
 * step was done twice, flows out. It may not know how the platform recovers.
 */
@NullMarked
package org.maestro.bench.losses;

import org.jspecify.annotations.NullMarked;
