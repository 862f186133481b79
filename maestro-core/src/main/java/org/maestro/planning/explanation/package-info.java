/**
 * Why there is no plan, and why a step was given to its member: the least set of conditions with
 * which there would be one, found by planning with them. A task that has no plan, or a plan, flows
 * in; obstacles and choices flow out.
 */
@NullMarked
package org.maestro.planning.explanation;

import org.jspecify.annotations.NullMarked;
