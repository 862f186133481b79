/**
 * What many devices can be set to, and what their settings add up to: the light of lamps and
 * shutters at a place. A ground problem flows in; sums, the choices of which they consist, and the
 * conditions that some choice meets flow out. It searches nothing.
 */
@NullMarked
package org.maestro.planning.settings;

import org.jspecify.annotations.NullMarked;
