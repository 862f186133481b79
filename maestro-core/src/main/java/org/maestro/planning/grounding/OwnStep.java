package org.maestro.planning.grounding;

import java.util.Optional;
import org.maestro.sl.Term;

/**
 * A step that gives a variable another value, such as one from a zone into the next.
 *
 * @param from the value that it has to have before; empty when any will do
 * @param to a variable where the step's parameters do not tell it
 * @param cost at least; cost units
 */
record OwnStep(Optional<Term> from, Term to, double cost) {}
