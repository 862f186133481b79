package org.maestro.random;

import java.util.List;
import java.util.Map;

/**
 * A home that nobody built, with its truth, what is asked in it, and what goes wrong.
 *
 * @param seed from which all of it follows
 * @param homeText in Turtle
 * @param sceneText in Turtle: the truth at the beginning
 * @param goals in MAESTRO-SL, all stated at once
 * @param faults in the order of their times
 * @param physics what is otherwise than usual in its world: values of settings by their names
 */
public record RandomHome(
    long seed,
    String homeText,
    String sceneText,
    List<String> goals,
    List<Fault> faults,
    Map<String, String> physics) {
  public RandomHome {
    goals = List.copyOf(goals);
    faults = List.copyOf(faults);
    physics = Map.copyOf(physics);
  }

  /** One in the usual world. */
  public RandomHome(
      long seed, String homeText, String sceneText, List<String> goals, List<Fault> faults) {
    this(seed, homeText, sceneText, goals, faults, Map.of());
  }

  /** The same in another world. */
  public RandomHome in(Map<String, String> other) {
    return new RandomHome(seed, homeText, sceneText, goals, faults, other);
  }

  /** How faults of loading call it. */
  public String name() {
    return "random-" + seed;
  }
}
