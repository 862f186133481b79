package org.maestro.planning.problem;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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
public final class Variable {
  public static final int NONE = -1;
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

  /** Of how many values, in their order, the facts were asked, none of which is the one. */
  private int asked;

  private final BitSet foundFalse = new BitSet();
  private boolean noneElsewhere;

  /**
   * A state variable.
   *
   * @param possibleValues individuals that may be its value at first; empty unless functional
   */
  public Variable(
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

  public boolean functional() {
    return functional;
  }

  public boolean observable() {
    return observable;
  }

  public String predicate() {
    return predicate;
  }

  /** The facts may have changed. */
  void renew() {
    initial = UNASKED;
    asked = 0;
    foundFalse.clear();
    noneElsewhere = false;
  }

  /** Without the value, if functional. */
  public List<Term> arguments() {
    return arguments;
  }

  public int index() {
    return index;
  }

  void placeAt(int stateIndex) {
    index = stateIndex;
  }

  /** The index of a value; a value not met before is added. */
  public int indexOf(Term value) {
    Integer known = indexOfValue.get(value);
    if (known != null) {
      return known;
    }
    values.add(value);
    indexOfValue.put(value, values.size() - 1);
    if (initial < 0) {
      initial = UNASKED;
    }
    return values.size() - 1;
  }

  /** How many values were met. */
  public int valueCount() {
    return values.size();
  }

  /** The value of that index. */
  public Term value(int value) {
    return values.get(value);
  }

  public Formula.Atom atom(int value) {
    if (!functional) {
      return new Formula.Atom(predicate, arguments);
    }
    List<Term> all = new ArrayList<>(arguments);
    all.add(values.get(value));
    return new Formula.Atom(predicate, all);
  }

  /** The code given by the facts. */
  public int initialCode() {
    if (initial == UNASKED) {
      int among = codeAmongMet();
      initial = among < 0 ? otherThanMet().map(this::indexOf).orElse(among) : among;
    }
    return initial;
  }

  private int codeAmongMet() {
    for (; asked < values.size(); asked++) {
      Truth truth = facts.truth(atom(asked));
      if (truth == Truth.TRUE) {
        return asked;
      }
      if (truth == Truth.FALSE) {
        foundFalse.set(asked);
      }
    }
    return observable ? intern((BitSet) foundFalse.clone()) : NONE;
  }

  /** The value at first, if it is one that was not met yet: there is no more than one. */
  private Optional<Term> otherThanMet() {
    if (noneElsewhere) {
      return Optional.empty();
    }
    Optional<Term> other =
        possibleValues.stream()
            .filter(value -> !indexOfValue.containsKey(value) && truthOf(value) == Truth.TRUE)
            .findFirst();
    noneElsewhere = other.isEmpty();
    return other;
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
  public boolean isUnknown(int code, int value) {
    return observable && code < 0 && !exclusions.get(NONE - code).get(value);
  }

  /** The code after the value was said not to hold. */
  public int without(int code, int value) {
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
  public List<Term> excluded(int code) {
    return code >= 0
        ? List.of()
        : exclusions.get(NONE - code).stream().mapToObj(values::get).toList();
  }
}
