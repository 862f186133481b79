/**
 * Benchmarks of the planner: its time on random homes, beside a peer where one is installed, again
 * when an agent left, and for how long it goes on when it is cancelled. A size flows in, rows of
 * figures flow out. It may not know of agents or a bus.
 */
@NullMarked
package org.maestro.bench.planning;

import org.jspecify.annotations.NullMarked;
