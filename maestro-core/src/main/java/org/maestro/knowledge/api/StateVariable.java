package org.maestro.knowledge.api;

import java.util.ArrayList;
import java.util.List;
import org.maestro.sl.Term;

/**
 * A variable that has one value at a time: a number, a functional predicate of the arguments before
 * its last, or the truth of any other atom.
 */
public record StateVariable(String predicate, List<Term> arguments) {
  public StateVariable {
    arguments = List.copyOf(arguments);
  }

  /** Whether the first argument is this. */
  public boolean isAbout(Term subject) {
    return !arguments.isEmpty() && arguments.get(0).equals(subject);
  }

  /** The arguments of the atom that gives a functional predicate this value. */
  public List<Term> with(Term value) {
    List<Term> all = new ArrayList<>(arguments);
    all.add(value);
    return List.copyOf(all);
  }
}
