package org.maestro.coordination.composites;

import java.util.function.Consumer;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.Ports;
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
   * @return what cancels it
   */
  Runnable begin(String id, Formula.Atom script, Ports ports, Consumer<GoalOutcome> ended);

  /** The same of one that may have begun before a restart: it goes on where it was. */
  Runnable takeUp(String id, Formula.Atom script, Ports ports, Consumer<GoalOutcome> ended);

  /** Nobody goes on with one that had begun before a restart; what was under way for it ends. */
  void giveUp(String id);
}
