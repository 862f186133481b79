package org.maestro.experiment;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.maestro.coordination.api.GoalCheck;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.experiment.setting.SettingException;
import org.maestro.ontology.home.Home;
import org.maestro.sim.scene.Scene;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/**
 * Homes that are to be compared, and the goals that are to be reached in each of them (ADE, 6;
 * A93). Immutable.
 *
 * @param given the words of a command line that name all this
 */
public record Comparison(List<SetUp> setUps, List<Wish> wishes, String given) {

  /**
   * One of the homes, with what is true in it at first.
   *
   * @param name by which it is told from the others, such as its file's
   */
  public record SetUp(String name, Home home, Scene scene) {}

  /**
   * @throws SettingException when there is nothing to compare, or one of the homes does not know
   *     what is wanted
   */
  public Comparison {
    setUps = List.copyOf(setUps);
    wishes = List.copyOf(wishes);
    if (setUps.size() < 2) {
      throw new SettingException("Two homes at least are compared; name each with --home.");
    }
    if (wishes.isEmpty()) {
      throw new SettingException(
          "Nothing is wanted in these homes; give a goal with --goal, or a file of goals with"
              + " --goals.");
    }
    Set<String> names = new HashSet<>();
    for (SetUp setUp : setUps) {
      if (!names.add(setUp.name())) {
        throw new SettingException(
            "Two of the homes are called %s; give each a name of its own.".formatted(setUp.name()));
      }
      wishes.forEach(wish -> check(setUp, wish));
    }
  }

  private static void check(SetUp setUp, Wish wish) {
    Formula goal;
    try {
      goal = SlParser.formula(wish.goal(), setUp.home().vocabulary()::isFluent);
      new GoalCheck(setUp.home()).check(new GoalRequest(goal, "comparison"));
    } catch (InvalidGoalException | SlSyntaxException e) {
      throw new SettingException(
          "In %s the goal %s cannot be stated, so that nothing is compared: %s"
              .formatted(setUp.name(), wish.goal(), e.getMessage()));
    }
    if (goal instanceof Formula.Keep || goal instanceof Formula.Bound) {
      throw new SettingException(
          "The goal %s has no end at which set-ups could be compared; state what is to be so, with a time in front of it if it is to come later."
              .formatted(wish.goal()));
    }
  }
}
