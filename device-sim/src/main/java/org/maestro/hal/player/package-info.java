/**
 * A robot's base behind a Player server, the one that many robots of the years around 2005 come
 * with (ADE, 3.3; A40). Velocities flow out over TCP, poses by odometry and stalls flow in. What
 * the robot can do is with {@link org.maestro.hal.wheels}; nothing here knows the home or the bus.
 */
@NullMarked
package org.maestro.hal.player;

import org.jspecify.annotations.NullMarked;
