package org.maestro.random;

import java.time.Duration;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.sl.Formula;

/** A site in which a random home comes to life on the stepped clock. For one thread. */
interface Arena extends Fault.Stage, AutoCloseable {

  Formula parsed(String goal);

  /** What the platform believes. */
  KnowledgeBase knowledge();

  /**
   * One of both is told, once, on the thread that lets time pass.
   *
   * @param refused why the goal is not taken on
   */
  void pursue(String goal, Consumer<Claim> ended, Consumer<String> refused);

  /**
   * States a goal that is to be held.
   *
   * @param told each time that it begins to be so, and when it is said that it cannot be, on the
   *     thread that lets time pass
   */
  void hold(String goal, Consumer<Claim> told);

  boolean runUntil(BooleanSupplier condition, Duration limit);

  List<String> story();

  @Override
  void close();
}
