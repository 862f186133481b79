/**
 * Hardware behind ROS, by the rosbridge protocol, version 2: JSON over a WebSocket (Three-layered
 * architecture, 4.3; M89). Velocities flow out, odometry and poses, light, warmth and detections
 * flow in; a server that is lost is connected to again. What the hardware can do is with {@link
 * org.maestro.hal} and {@link org.maestro.hal.wheels}; nothing here knows the home or the bus.
 */
@NullMarked
package org.maestro.hal.ros;

import org.jspecify.annotations.NullMarked;
