package org.maestro.coordination.maintenance;

import java.util.function.Consumer;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.contention.ActiveGoal;

/** Begins a goal that is to be reached once. */
public interface Reaching {
  ActiveGoal pursuit(GoalRequest request, Ports ports, Consumer<GoalOutcome> ended);
}
