package org.maestro.coordination.api;

import java.util.List;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Formula;

/**
 * A reasoner of somebody else's, such as a rule engine or a cognitive architecture, which a
 * platform hosts beside its planner (ADE, 3; A16): it sees what is known, and says which goals it
 * wants; how these are reached stays the planner's business. Whoever lists a class of it as a
 * service for {@link java.util.ServiceLoader} in the class path of a platform has it hosted. Each
 * central agent has its own, and calls it on one thread.
 */
public interface Reasoner {

  /**
   * The name, as agents have names, in which its goals are stated; where a home states permissions
   * it needs one for what it wants done.
   */
  String name();

  /**
   * The goals that it wants now. Called at the beginning and after changes of what is known; the
   * agent does nothing else meanwhile, so that it has to answer within milliseconds. A goal is
   * stated when it comes to be wanted, and not again before it has ceased to be.
   *
   * @param known as it is now; private facts included
   */
  List<Formula> wanted(Snapshot known);
}
