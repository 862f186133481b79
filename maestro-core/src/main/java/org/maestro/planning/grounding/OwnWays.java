package org.maestro.planning.grounding;

import java.util.Set;
import org.maestro.sl.Term;

/**
 * What it costs at least until a variable has a value, by the steps that change it alone: for where
 * a robot is, its ways through the house, whatever else the steps need.
 *
 * @param first the value that the variable has
 * @param graph of all steps that change it
 * @param features the numbers of the features that have these steps
 */
record OwnWays(Term first, OwnGraph graph, Set<Integer> features) {

  /** Cost units from 0; infinite when no steps lead there. */
  double costTo(Term value) {
    return graph.cost(first, value);
  }

  /** As {@link #costTo}, from another value. */
  double between(Term from, Term to) {
    return graph.cost(from, to);
  }
}
