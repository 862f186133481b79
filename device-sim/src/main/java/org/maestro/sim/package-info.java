/**
 * The simulated world: floor, light, things, and the drivers that act in it, with faults. A home
 * and a scene (the ground truth) flow in, drivers for {@link org.maestro.hal} flow out, and tests
 * look at and change the world itself. It takes all time from the clock and all chance from one
 * seed. Nothing above the drivers may know it.
 */
@NullMarked
package org.maestro.sim;

import org.jspecify.annotations.NullMarked;
