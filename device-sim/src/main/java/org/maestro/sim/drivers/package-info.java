/**
 * Simulated hardware behind the interfaces of the HAL: bases, arms, grippers, cameras, lamps,
 * sensors, doors. Commands flow in; motion, pictures and readings, with noise and defects, flow out
 * of the world's physics. They act on the world's parts, and know nothing of members.
 */
@NullMarked
package org.maestro.sim.drivers;

import org.jspecify.annotations.NullMarked;
