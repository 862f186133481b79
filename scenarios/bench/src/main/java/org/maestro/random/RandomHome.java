package org.maestro.random;

import java.util.List;

/**
 * A home that nobody built, with its truth, what is asked in it, and what goes wrong.
 *
 * @param seed from which all of it follows
 * @param homeText in Turtle
 * @param sceneText in Turtle: the truth at the beginning
 * @param goals in MAESTRO-SL, all stated at once
 * @param faults in the order of their times
 */
public record RandomHome(
    long seed, String homeText, String sceneText, List<String> goals, List<Fault> faults) {
  public RandomHome {
    goals = List.copyOf(goals);
    faults = List.copyOf(faults);
  }

  /** How faults of loading call it. */
  public String name() {
    return "random-" + seed;
  }
}
