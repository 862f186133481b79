/**
 * Bases on wheels: a way to drive becomes velocities, velocities become wheel speeds by the
 * geometry of the wheels (Three-layered architecture, 4.1; M80). Motors and localization may be
 * hardware or simulated.
 */
@NullMarked
package org.maestro.hal.wheels;

import org.jspecify.annotations.NullMarked;
