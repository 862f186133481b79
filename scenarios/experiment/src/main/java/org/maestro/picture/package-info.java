/**
 * The picture of what happened: a home from above. A home and its simulated world flow in, a PNG
 * file flows out. It draws, and decides nothing.
 */
@NullMarked
package org.maestro.picture;

import org.jspecify.annotations.NullMarked;
