/**
 * Reads planning tasks in PDDL. Text, also compressed, flows in, a {@link
 * org.maestro.planning.ground.LiftedTask} flows out; what is not understood is named with its line
 * and column. It knows nothing of how tasks are made ground or solved.
 */
@NullMarked
package org.maestro.planning.pddl;

import org.jspecify.annotations.NullMarked;
