package org.maestro.knowledge.belief;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.sl.Term;

/**
 * A trie of what is known of all state variables, in the order in which they were first spoken of.
 * Immutable: a change shares all but a few small arrays with what was before, so that neither a
 * write nor a snapshot copies what is known. Numbers of variables are common to all versions and
 * are never given back; there are as many as things that can be said of the home.
 */
public final class Cells {

  private static final int BITS = 5;
  private static final int WIDTH = 1 << BITS;
  private static final int MASK = WIDTH - 1;

  private final Numbers numbers;
  private final Object[] root;
  private final int shift;

  private Cells(Numbers numbers, Object[] root, int shift) {
    this.numbers = numbers;
    this.root = root;
    this.shift = shift;
  }

  static Cells none() {
    return new Cells(new Numbers(), new Object[WIDTH], 0);
  }

  Optional<Cell> get(StateVariable variable) {
    Integer number = numbers.byVariable.get(variable);
    return number == null || number >>> shift + BITS != 0
        ? Optional.empty()
        : Optional.ofNullable(at(number));
  }

  /** Whether anything was ever said of the predicate, in this version or another. */
  boolean speakOf(String predicate) {
    return numbers.predicates.contains(predicate);
  }

  private @Nullable Cell at(int number) {
    Object[] node = root;
    for (int level = shift; level > 0; level -= BITS) {
      node = (Object[]) node[number >>> level & MASK];
      if (node == null) {
        return null;
      }
    }
    return (Cell) node[number & MASK];
  }

  /** One writer at a time. */
  public Cells with(StateVariable variable, Cell cell) {
    int number = numbers.of(variable);
    Object[] top = root;
    int level = shift;
    while (number >>> level + BITS != 0) {
      top = lifted(top);
      level += BITS;
    }
    return new Cells(numbers, changed(top, level, number, cell), level);
  }

  private static Object[] changed(Object @Nullable [] node, int level, int number, Cell cell) {
    Object[] copy = node == null ? new Object[WIDTH] : Arrays.copyOf(node, WIDTH);
    int place = number >>> level & MASK;
    copy[place] = level == 0 ? cell : changed((Object[]) copy[place], level - BITS, number, cell);
    return copy;
  }

  public void forEach(BiConsumer<StateVariable, Cell> visitor) {
    int known = Math.min(numbers.variables.size(), 1 << Math.min(shift + BITS, 30));
    for (int number = 0; number < known; number++) {
      Cell cell = at(number);
      if (cell != null) {
        visitor.accept(numbers.variables.get(number), cell);
      }
    }
  }

  /** All of which anything is or was known. */
  Set<Term> spokenOf() {
    Set<Term> spokenOf = new HashSet<>();
    forEach(
        (variable, cell) -> {
          spokenOf.addAll(variable.arguments());
          cell.standing().forEach(claim -> spokenOf.add(claim.value()));
          cell.overruled().forEach(claim -> spokenOf.add(claim.value()));
          cell.last().ifPresent(held -> spokenOf.add(held.value()));
        });
    return spokenOf;
  }

  /**
   * Visits the variables whose cells are not the very same in the other version.
   *
   * @return false when the other is no version of these
   */
  boolean forEachDifference(Cells other, BiConsumer<StateVariable, Optional<Cell>> visitor) {
    if (numbers != other.numbers) {
      return false;
    }
    Object[] mine = root;
    Object[] others = other.root;
    int level = Math.max(shift, other.shift);
    for (int mineAt = shift; mineAt < level; mineAt += BITS) {
      mine = lifted(mine);
    }
    for (int othersAt = other.shift; othersAt < level; othersAt += BITS) {
      others = lifted(others);
    }
    compare(mine, others, level, 0, visitor);
    return true;
  }

  private static Object[] lifted(Object[] node) {
    Object[] higher = new Object[WIDTH];
    higher[0] = node;
    return higher;
  }

  private void compare(
      Object @Nullable [] mine,
      Object @Nullable [] others,
      int level,
      int first,
      BiConsumer<StateVariable, Optional<Cell>> visitor) {
    for (int place = 0; place < WIDTH; place++) {
      Object own = mine == null ? null : mine[place];
      Object other = others == null ? null : others[place];
      int number = first + (place << level);
      if (own != other && level > 0) {
        compare((Object[]) own, (Object[]) other, level - BITS, number, visitor);
      } else if (own != other) {
        visitor.accept(numbers.variables.get(number), Optional.ofNullable((Cell) own));
      }
    }
  }

  /** The numbering of the variables. Readers need not wait for the writer. */
  private static final class Numbers {
    private final Map<StateVariable, Integer> byVariable = new ConcurrentHashMap<>();
    private final List<StateVariable> variables = Collections.synchronizedList(new ArrayList<>());
    private final Set<String> predicates = ConcurrentHashMap.newKeySet();

    int of(StateVariable variable) {
      Integer known = byVariable.get(variable);
      if (known != null) {
        return known;
      }
      variables.add(variable);
      predicates.add(variable.predicate());
      byVariable.put(variable, variables.size() - 1);
      return variables.size() - 1;
    }
  }
}
