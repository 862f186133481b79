package org.maestro.junit;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import org.maestro.knowledge.KnowledgeBase;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.platform.MaestroPlatform;
import org.maestro.rats.time.Clock;
import org.maestro.sim.World;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/**
 * A running platform with the simulated home behind it, as a test sees it. Time passes only while
 * the test waits when the clock is stepped. For the test's thread.
 */
public final class Stage implements AutoCloseable {

  private final Production production;
  private final Duration patience;

  Stage(Production production, Duration patience) {
    this.production = production;
    this.patience = patience;
  }

  /** States a goal and waits for its end. A goal that is not MAESTRO-SL is a refused one. */
  public GoalOutcome goal(String goal) {
    return begin(goal).await();
  }

  /** States a goal, and leaves it under way. */
  public Pursuit begin(String goal) {
    try {
      return Pursuit.begin(production, goal, parsed(goal), patience);
    } catch (SlSyntaxException e) {
      return Pursuit.refused(production, goal, e.getMessage());
    }
  }

  /** What the platform knows. */
  public KnowledgeBase knowledge() {
    return production.platform().knowledge();
  }

  /** The truth behind it: ask it, and change it. */
  public World world() {
    return production.world();
  }

  public MaestroPlatform platform() {
    return production.platform();
  }

  public Clock clock() {
    return production.clock();
  }

  /** Lets simulated time pass. */
  public void run(Duration time) {
    production.runUntil(() -> false, time);
  }

  /** Lets time pass until the condition holds; fails the test when it does not in time. */
  public void await(String what, BooleanSupplier condition) {
    if (!production.runUntil(condition, patience)) {
      throw new StageException("It did not happen within " + patience + ": " + what + ".");
    }
  }

  /**
   * The device's power fails: it vanishes from the bus without goodbye, and lets go of what it
   * holds.
   */
  public void kill(String device) {
    production.kill(device);
  }

  /** The device is switched on again, and joins anew. */
  public void revive(String device) {
    production.revive(device);
  }

  @Override
  public void close() {
    production.close();
  }

  private Formula parsed(String goal) {
    return SlParser.formula(
        goal,
        name ->
            knowledge()
                .home()
                .vocabulary()
                .predicate(name)
                .filter(PredicateDeclaration::fluent)
                .isPresent());
  }
}
