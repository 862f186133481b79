/**
 * The routines of devices, by the key under which descriptions name them: driving, picking,
 * placing, looking, measuring, lighting. A call's parameters and the device's drivers flow in;
 * progress, results and prices flow out. Each says why it cannot be done; none knows the bus or the
 * simulation.
 */
@NullMarked
package org.maestro.device.tasks;

import org.jspecify.annotations.NullMarked;
