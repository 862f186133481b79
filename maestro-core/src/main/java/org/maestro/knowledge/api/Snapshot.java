package org.maestro.knowledge.api;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * The collective knowledge at one moment. Immutable; any thread may read it. Too-old facts are
 * unknown in it.
 */
public interface Snapshot extends Facts {

  /** Grows with each change. */
  long version();

  Optional<Belief> belief(Formula.Atom atom);

  Optional<Belief> belief(Expression.Fluent fluent);

  /**
   * All that sources say now of what the atom speaks of, also what is not believed; what stands in
   * the home is left out.
   */
  List<Belief> claims(Formula.Atom atom);

  /** All that sources say now of the number, also what is not believed. */
  List<Belief> claims(Expression.Fluent fluent);

  /**
   * The value of a functional predicate, {@code (position Cup ?)}: a name, or a text for a
   * position; empty when unknown.
   */
  Optional<Term> value(String predicate, List<Term> arguments);

  /** All current dynamic facts (not those described in the home), sorted by their text. */
  List<Belief> beliefs();

  /** When it was taken: ages are reckoned from then. */
  Instant at();

  /**
   * The same moment for a reader to whom older statements mean nothing. What stands in the home has
   * no age.
   */
  Snapshot notOlderThan(Duration age);

  /**
   * The same moment; tells the witness each belief from which it answers, also what the home says.
   */
  Snapshot witnessed(Consumer<Belief> witness);

  /**
   * The value that a state variable had when something was known of it last, however long ago, also
   * before a restart: {@code ("in", Cup)} gives {@code (in Cup zone-b)}; empty when nothing ever
   * was.
   */
  Optional<Belief> lastKnown(String predicate, List<Term> arguments);

  /** All on which sources disagree now, and how that was settled. */
  List<Dispute> disputes();
}
