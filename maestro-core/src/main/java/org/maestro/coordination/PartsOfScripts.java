package org.maestro.coordination;

import java.util.function.Consumer;
import org.maestro.coordination.achievement.AchievementGoal;
import org.maestro.coordination.achievement.CallGoal;
import org.maestro.coordination.achievement.FeatureCall;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.lessons.VainDeeds;
import org.maestro.coordination.recovery.JournaledDispatcher;
import org.maestro.coordination.scripts.Subgoals;

/** Goals for parts of scripts; how a script as a whole is ended is no matter of theirs. */
record PartsOfScripts(
    Roster roster, ActiveGoals activeGoals, ExactPrices exactPrices, JournaledDispatcher dispatcher)
    implements Subgoals {
  @Override
  public ActiveGoal reaching(
      String id, GoalRequest request, Ports with, Consumer<GoalOutcome> ended) {
    return new AchievementGoal(
        id, request, with, roster, activeGoals, exactPrices, new VainDeeds(), ended);
  }

  @Override
  public ActiveGoal calling(
      String id, FeatureCall call, GoalRequest request, Ports with, Consumer<GoalOutcome> ended) {
    return new CallGoal(id, call, request, with, roster, activeGoals, exactPrices, ended);
  }

  @Override
  public void over(String id) {
    dispatcher.over(id);
  }
}
