/**
 * The truth of a simulated home, for who develops for it: it is handed in by whoever runs the
 * simulation, goes out as a document, and is known to nobody else here; the console itself sees no
 * simulation, and what the platform knows does not come from here.
 */
@NullMarked
package org.maestro.console.truth;

import org.jspecify.annotations.NullMarked;
