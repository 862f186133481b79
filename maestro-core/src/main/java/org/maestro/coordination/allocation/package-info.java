/**
 * Prices and plans for one goal: members are called for proposals by contract net, the planner
 * weighs them, exact prices are asked where they could change the choice. A goal and what is known
 * flow in; a plan with its tenders, or why there is none, flows out. It begins no step.
 */
@NullMarked
package org.maestro.coordination.allocation;

import org.jspecify.annotations.NullMarked;
