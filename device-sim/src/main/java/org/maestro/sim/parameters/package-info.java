/**
 * Every number of the simulated physics with its source, and its name in settings. A setting's text
 * flows in; checked parameters flow out. They know nothing of the world that goes by them.
 */
@NullMarked
package org.maestro.sim.parameters;

import org.jspecify.annotations.NullMarked;
