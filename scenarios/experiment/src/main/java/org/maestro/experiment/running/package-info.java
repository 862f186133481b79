/**
 * One run of an experiment: a whole platform in a simulated home, on the stepped clock or on the
 * paced one over a real broker. A trial flows in; how its goals ended, what was told and where the
 * robots went flow out. What is true is asked of the simulated world, never of the platform.
 */
@NullMarked
package org.maestro.experiment.running;

import org.jspecify.annotations.NullMarked;
