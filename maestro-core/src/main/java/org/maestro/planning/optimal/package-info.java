/**
 * The search for the cheapest or soonest plan of a ground problem, with proof: A* with landmark
 * cuts, knapsack bounds, stubborn sets. A ground problem and limits flow in; operators in order, or
 * that there are none, flow out. It knows no home, and of features no more than their names.
 */
@NullMarked
package org.maestro.planning.optimal;

import org.jspecify.annotations.NullMarked;
