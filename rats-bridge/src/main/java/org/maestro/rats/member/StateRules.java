package org.maestro.rats.member;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * The transitions of a member's state z that are allowed (Three-layered architecture, 3.2.1; M35),
 * and what happens when nobody is left to tell it.
 *
 * @param transitions from a state to those that may follow; one without an entry may be followed by
 *     any
 * @param byTime states that the member leaves by itself when it rested in them for long enough
 * @param lastResort what to do when an exit strategy fails; empty: rest in a safe state
 * @param restAfterLoss simulated time from the loss of a controller to the end of what it keeps
 *     going
 */
public record StateRules(
    Map<String, Set<String>> transitions,
    Map<String, AfterTime> byTime,
    Optional<LastResort> lastResort,
    Duration restAfterLoss) {

  private static final Duration USUAL_REST_AFTER_LOSS = Duration.ofMinutes(1);

  /** Any state may follow any other. */
  public static final StateRules FREE =
      new StateRules(Map.of(), Map.of(), Optional.empty(), USUAL_REST_AFTER_LOSS);

  public StateRules {
    transitions = Map.copyOf(transitions);
    byTime = Map.copyOf(byTime);
  }

  /** To another state after some simulated time at rest. */
  public record AfterTime(Duration time, String state) {}

  /**
   * The strongest safe state, and how to force the device into it without its cooperation, such as
   * cutting the power of its motors. The action must not block.
   */
  public record LastResort(String state, Runnable action) {}

  boolean allows(String from, String to) {
    return from.equals(to) || !transitions.containsKey(from) || transitions.get(from).contains(to);
  }

  /** All states that are named here. */
  Set<String> states() {
    Set<String> states = new TreeSet<>(transitions.keySet());
    transitions.values().forEach(states::addAll);
    states.addAll(byTime.keySet());
    byTime.values().forEach(after -> states.add(after.state()));
    lastResort.ifPresent(resort -> states.add(resort.state()));
    return states;
  }
}
