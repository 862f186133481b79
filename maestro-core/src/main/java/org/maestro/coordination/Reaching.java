package org.maestro.coordination;

import java.util.function.Consumer;

/** Begins a goal that is to be reached once. */
interface Reaching {
  Pursuit pursuit(GoalRequest request, Ports ports, Consumer<GoalOutcome> ended);
}
