/**
 * Tasks written as PDDL for other planners, or the sentence that says what PDDL cannot carry. It
 * solves nothing.
 */
@NullMarked
package org.maestro.planning.export;

import org.jspecify.annotations.NullMarked;
