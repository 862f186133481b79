/**
 * Benchmarks of the bus: calls and prices asked over it, beside the bare MQTT client at the same
 * broker. How many members and calls flows in, rows of figures flow out. It may not know of agents
 * or a platform.
 */
@NullMarked
package org.maestro.bench.bus;

import org.jspecify.annotations.NullMarked;
