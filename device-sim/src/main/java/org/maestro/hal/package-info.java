/**
 * The hardware abstraction layer: one plain interface per kind of hardware, from a lamp's dimmer to
 * a robot's arm, as atomic functions (Three-layered architecture, 3.1; M26). Commands flow in,
 * measurements and completions flow out. Nothing blocks: whatever takes time reports to a callback
 * on the clock's thread, and commands come from there too. It knows neither who uses a driver nor
 * whether hardware or a simulation stands behind it.
 */
@NullMarked
package org.maestro.hal;

import org.jspecify.annotations.NullMarked;
