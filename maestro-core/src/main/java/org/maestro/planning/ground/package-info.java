/**
 * From operators with parameters to a ground task over whole numbers. A {@link
 * org.maestro.planning.ground.LiftedTask} flows in, whoever wrote it; what cannot matter for its
 * goal is left out before anything is enumerated. The {@link
 * org.maestro.planning.ground.GroundTask} that flows out knows facts, sums and costs by number. It
 * knows neither PDDL nor how a plan is searched for.
 */
@NullMarked
package org.maestro.planning.ground;

import org.jspecify.annotations.NullMarked;
