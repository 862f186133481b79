/**
 * The sky over a home: where the sun stands at an hour of a day, how much light it and the sky
 * give, and clouds that come and go by a seed. A moment flows in, the light outdoors flows out. It
 * knows neither homes nor devices.
 */
@NullMarked
package org.maestro.sim.sky;

import org.jspecify.annotations.NullMarked;
