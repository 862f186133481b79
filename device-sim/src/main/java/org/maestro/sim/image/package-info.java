/**
 * Pictures of the simulated world as its cameras take them: rays through a pin-hole, light upon
 * surfaces, exposure and noise. What is to be drawn flows in, a {@link org.maestro.hal.Photo} flows
 * out. It knows shapes, colours and light, and nothing of the world they come from. Only who asks
 * for a picture pays for it.
 */
@NullMarked
package org.maestro.sim.image;

import org.jspecify.annotations.NullMarked;
