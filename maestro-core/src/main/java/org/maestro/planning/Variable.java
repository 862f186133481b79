package org.maestro.planning;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * A state variable: the value of a functional predicate for given arguments, or a single atom (then
 * there is one value, "it holds").
 *
 * <p>Its state is a code. A code from 0 is the index of the known value. A negative code says that
 * no value is known, and stands for the set of excluded values; a closed-world variable has only
 * the code {@link #NONE}.
 */
final class Variable {
  static final int NONE = -1;
  private static final int UNASKED = Integer.MIN_VALUE;

  private final String predicate;
  private final List<Term> arguments;
  private final boolean functional;
  private final boolean observable;
  private final StaticFacts facts;
  private final List<Term> possibleValues;

  private final List<Term> values = new ArrayList<>();
  private final Map<Term, Integer> indexOfValue = new HashMap<>();
  private final List<BitSet> exclusions = new ArrayList<>();
  private final Map<BitSet, Integer> indexOfExclusion = new HashMap<>();
  private int index = -1;
  private int initial = UNASKED;

  /**
   * A state variable.
   *
   * @param possibleValues individuals that may be its value at first; empty unless functional
   */
  Variable(
      String predicate,
      List<Term> arguments,
      boolean functional,
      boolean observable,
      StaticFacts facts,
      List<Term> possibleValues) {
    this.predicate = predicate;
    this.arguments = List.copyOf(arguments);
    this.functional = functional;
    this.observable = observable;
    this.facts = facts;
    this.possibleValues = possibleValues;
    intern(new BitSet());
    if (!functional) {
      values.add(new Term.Truth(true));
    }
  }

  boolean functional() {
    return functional;
  }

  boolean observable() {
    return observable;
  }

  String predicate() {
    return predicate;
  }

  /** The facts may have changed. */
  void renew() {
    initial = UNASKED;
  }

  /** Without the value, if functional. */
  List<Term> arguments() {
    return arguments;
  }

  int index() {
    return index;
  }

  void placeAt(int stateIndex) {
    index = stateIndex;
  }

  /** The index of a value; a value not met before is added. */
  int indexOf(Term value) {
    Integer known = indexOfValue.get(value);
    if (known != null) {
      return known;
    }
    values.add(value);
    indexOfValue.put(value, values.size() - 1);
    initial = UNASKED;
    return values.size() - 1;
  }

  /** How many values were met. */
  int valueCount() {
    return values.size();
  }

  /** The value of that index. */
  Term value(int value) {
    return values.get(value);
  }

  Formula.Atom atom(int value) {
    if (!functional) {
      return new Formula.Atom(predicate, arguments);
    }
    List<Term> all = new ArrayList<>(arguments);
    all.add(values.get(value));
    return new Formula.Atom(predicate, all);
  }

  /** The code given by the facts. */
  int initialCode() {
    if (initial == UNASKED) {
      for (Term value : possibleValues) {
        if (!indexOfValue.containsKey(value) && truthOf(value) == Truth.TRUE) {
          indexOf(value);
        }
      }
      initial = askInitialCode();
    }
    return initial;
  }

  private int askInitialCode() {
    BitSet excluded = new BitSet();
    for (int i = 0; i < values.size(); i++) {
      Truth truth = facts.truth(atom(i));
      if (truth == Truth.TRUE) {
        return i;
      }
      if (truth == Truth.FALSE) {
        excluded.set(i);
      }
    }
    return observable ? intern(excluded) : NONE;
  }

  private Truth truthOf(Term value) {
    List<Term> all = new ArrayList<>(arguments);
    all.add(value);
    return facts.truth(new Formula.Atom(predicate, all));
  }

  private int intern(BitSet excluded) {
    Integer known = indexOfExclusion.get(excluded);
    if (known == null) {
      known = exclusions.size();
      exclusions.add(excluded);
      indexOfExclusion.put(excluded, known);
    }
    return NONE - known;
  }

  /** Whether, under the code, the value is neither known nor excluded. */
  boolean isUnknown(int code, int value) {
    return observable && code < 0 && !exclusions.get(NONE - code).get(value);
  }

  /** The code after the value was said not to hold. */
  int without(int code, int value) {
    if (code == value) {
      return functional || !observable ? NONE : exclude(NONE, value);
    }
    return code < 0 && observable ? exclude(code, value) : code;
  }

  private int exclude(int code, int value) {
    BitSet excluded = (BitSet) exclusions.get(NONE - code).clone();
    excluded.set(value);
    return intern(excluded);
  }

  /** The values that are excluded under a code. */
  List<Term> excluded(int code) {
    return code >= 0
        ? List.of()
        : exclusions.get(NONE - code).stream().mapToObj(values::get).toList();
  }
}
