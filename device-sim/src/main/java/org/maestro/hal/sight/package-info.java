/**
 * Detection of things in pictures by their colour and size, as a camera's software does it. A
 * {@link org.maestro.hal.Photo}, the lens that took it and the looks of what is wanted flow in;
 * where it may stand, and how sure that is, flows out. It knows nothing but the picture: neither
 * the world, nor whether that is simulated.
 */
@NullMarked
package org.maestro.hal.sight;

import org.jspecify.annotations.NullMarked;
