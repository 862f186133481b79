/**
 * The ground truth while it runs: floor and doors, light, bodies, batteries, defects. Drivers'
 * deeds and time flow in; what is so, and events, flow out. It knows no driver and no member.
 */
@NullMarked
package org.maestro.sim.world;

import org.jspecify.annotations.NullMarked;
