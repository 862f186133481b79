/**
 * Calibration of the fast model of a camera's detection against its detection in pictures. A home,
 * a camera and a thing flow in; what the pictures show in which light, the model's parameters that
 * come nearest, and how near, flow out. It knows the simulated world and its drivers, and neither
 * bus nor platform.
 */
@NullMarked
package org.maestro.sim.calibration;

import org.jspecify.annotations.NullMarked;
