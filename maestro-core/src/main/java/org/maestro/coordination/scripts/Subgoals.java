package org.maestro.coordination.scripts;

import java.util.function.Consumer;
import org.maestro.coordination.achievement.FeatureCall;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.contention.ActiveGoal;

/** The making of goals for parts of a script. */
public interface Subgoals {

  /** One that is planned. */
  ActiveGoal reaching(String id, GoalRequest request, Ports ports, Consumer<GoalOutcome> ended);

  /** One call of one member. */
  ActiveGoal calling(
      String id, FeatureCall call, GoalRequest request, Ports ports, Consumer<GoalOutcome> ended);

  /** One of them is over. */
  void over(String id);
}
