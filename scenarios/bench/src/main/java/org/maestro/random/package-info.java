/**
 * Random homes with random faults, and the judge of what is claimed in them. A seed flows in; a
 * home, its truth, goals and faults come of it, then the run's story and a verdict on each claim.
 * The judge looks at the simulated truth alone and shares nothing with the planner.
 */
@NullMarked
package org.maestro.random;

import org.jspecify.annotations.NullMarked;
