package org.maestro.coordination.composites;

import java.util.function.Consumer;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.sl.Formula;

/** The carrying out of scripts for steps of plans. */
public interface ScriptRuns {

  /**
   * Begins a script.
   *
   * @param id of the goal that it is, a part of the one for whose plan it is run
   * @param script its name with values for its parameters
   * @param ports the world in which its own steps are planned and done
   * @param ended told once, how it ended
   */
  ActiveGoal begin(String id, Formula.Atom script, Ports ports, Consumer<GoalOutcome> ended);
}
