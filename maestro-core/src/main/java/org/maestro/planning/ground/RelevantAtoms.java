package org.maestro.planning.ground;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * The atoms that could matter for a task's goal, found backwards from it without enumerating
 * operators: an object that no condition on the way to the goal can name does not appear. Functions
 * follow the predicates in the numbering of symbols.
 */
final class RelevantAtoms implements Relevance {
  /** So many bindings of one condition are told apart. */
  private static final int MOST_SPLITS = 300;

  /** And so many of each further one. */
  private static final int MOST_FURTHER_SPLITS = 12;

  private final LiftedTask task;
  private final GroundingBudget patience;
  private final @Nullable Relation[] statics;

  /** Of each predicate the tuples that may ever hold, as far as they are known; or null. */
  private final @Nullable Relation[] possible;

  private final MutexGroups spokes;
  private final Patterns holding = new Patterns();
  private final Patterns lacking = new Patterns();
  private final Patterns entered = new Patterns();
  private final List<Waiting> waiting = new ArrayList<>();
  private final Deque<Runnable> open = new ArrayDeque<>();
  private final Set<List<Integer>> used = new HashSet<>();
  private final IdentityHashMap<Schema, Integer> numberOf = new IdentityHashMap<>();
  private final List<Atom> released = new ArrayList<>();

  /** A schema that leaves a spoke, in case that the spoke is entered. */
  private record Waiting(Schema schema, int[] binding, Atom spoke) {}

  /**
   * @param statics the tuples of predicates that never change; null for the others
   * @throws java.util.concurrent.CancellationException when patience is over
   */
  RelevantAtoms(LiftedTask task, @Nullable Relation[] statics, GroundingBudget patience) {
    this.patience = patience;
    this.task = task;
    this.statics = statics;
    this.possible = statics.clone();
    for (int symbol = 0; symbol < statics.length; symbol++) {
      if (statics[symbol] == null) {
        possible[symbol] = possible(symbol);
      }
    }
    this.spokes = new MutexGroups(task, patience);
    task.schemas().forEach(schema -> numberOf.put(schema, numberOf.size()));
    List<Atom> initiallyEntered = new ArrayList<>();
    for (Atom atom : task.initial()) {
      patience.check();
      if (spokes.isSpoke(atom.symbol())) {
        entered.add(atom);
        initiallyEntered.add(atom);
      }
    }
    task.goals().forEach(goal -> need(goal, unbound(goal)));
    initiallyEntered.forEach(atom -> open.add(() -> release(atom)));
    while (!open.isEmpty()) {
      open.remove().run();
    }
  }

  /**
   * What may hold of a predicate all whose achievers name its objects in one static condition; null
   * for others.
   */
  private @Nullable Relation possible(int symbol) {
    Relation relation = new Relation(task.objects().size());
    for (Atom atom : task.initial()) {
      patience.check();
      if (atom.symbol() == symbol && relation.number(atom.terms()) < 0) {
        relation.add(atom.terms());
      }
    }
    for (Schema schema : task.schemas()) {
      for (Atom added : schema.additions()) {
        if (added.symbol() == symbol) {
          Atom cover = cover(schema, added);
          if (cover == null) {
            return null;
          }
          for (int i = 0; i < statics[cover.symbol()].size(); i++) {
            patience.check();
            int[] bound = bind(schema, unbound(schema), cover, statics[cover.symbol()].tuple(i));
            if (bound != null && relation.number(added.ground(bound)) < 0) {
              relation.add(added.ground(bound));
            }
          }
        }
      }
    }
    return relation;
  }

  private @Nullable Atom cover(Schema schema, Atom added) {
    for (Literal literal : schema.conditions()) {
      Atom atom = literal.atom();
      if (literal.positive()
          && statics[atom.symbol()] != null
          && Arrays.stream(added.terms())
              .filter(Atom::isParameter)
              .allMatch(term -> Arrays.stream(atom.terms()).anyMatch(other -> other == term))) {
        return atom;
      }
    }
    return null;
  }

  @Override
  public boolean mayHaveToHold(int symbol, int[] objects) {
    return holding.matches(symbol, objects);
  }

  @Override
  public boolean mayHaveToLack(int symbol, int[] objects) {
    return lacking.matches(symbol, objects);
  }

  @Override
  public boolean mayHaveToChange(int function, int[] objects) {
    return mayHaveToHold(symbolOfFunction(function), objects);
  }

  /** The symbol of a function's value. */
  private int symbolOfFunction(int function) {
    return task.predicates().size() + function;
  }

  private static int[] unbound(Schema schema) {
    int[] binding = new int[schema.domains().size()];
    Arrays.fill(binding, Patterns.ANY);
    return binding;
  }

  private static Atom pattern(Atom atom, int[] binding) {
    return new Atom(atom.symbol(), atom.ground(binding));
  }

  /** All that the schema's condition needs for a binding becomes relevant. */
  private void need(Schema schema, int[] binding) {
    split(schema, binding, 0);
  }

  /** Binds parameters by conditions that leave few choices, and then adds the rest. */
  private void split(Schema schema, int[] binding, int depth) {
    patience.check();
    Atom best = null;
    int fewest = 0;
    int lowest = Integer.MAX_VALUE;
    for (Literal literal : schema.conditions()) {
      Atom atom = literal.atom();
      if (!literal.positive() || possible[atom.symbol()] == null) {
        continue;
      }
      int[] pattern = atom.ground(binding);
      boolean open = Arrays.stream(pattern).anyMatch(object -> object < 0);
      boolean bound = Arrays.stream(pattern).anyMatch(object -> object >= 0);
      if (bound) {
        int count = count(possible[atom.symbol()], pattern);
        if (count == 0) {
          return;
        }
        // What is changed tells more: whoever it leaves open opens whole predicates.
        int rank = statics[atom.symbol()] == null || count == 1 ? count : MOST_SPLITS + count;
        if (open && count <= MOST_SPLITS && rank < lowest) {
          lowest = rank;
          fewest = count;
          best = atom;
        }
      }
    }
    if (best == null || depth > 0 && fewest > MOST_FURTHER_SPLITS) {
      addConditions(schema, binding);
      return;
    }
    Relation.Matches matches = possible[best.symbol()].matching(best.ground(binding));
    for (int i = 0; i < matches.size(); i++) {
      int[] bound =
          bind(schema, binding, best, possible[best.symbol()].tuple(matches.numbers()[i]));
      if (bound != null) {
        split(schema, bound, fewest == 1 ? depth : depth + 1);
      }
    }
  }

  private static int count(Relation relation, int[] pattern) {
    Relation.Matches matches = relation.matching(pattern);
    if (matches.size() > MOST_SPLITS) {
      return matches.size();
    }
    int count = 0;
    for (int i = 0; i < matches.size(); i++) {
      int[] tuple = relation.tuple(matches.numbers()[i]);
      boolean agrees = true;
      for (int place = 0; place < pattern.length; place++) {
        agrees &= pattern[place] < 0 || pattern[place] == tuple[place];
      }
      count += agrees ? 1 : 0;
    }
    return count;
  }

  /** The binding with the atom's parameters bound to the objects; null when they do not fit. */
  private static int @Nullable [] bind(Schema schema, int[] binding, Atom atom, int[] objects) {
    int[] bound = binding.clone();
    for (int i = 0; i < objects.length; i++) {
      int term = atom.terms()[i];
      int object = objects[i];
      if (object == Patterns.ANY) {
        continue;
      }
      if (!Atom.isParameter(term)) {
        if (term != object) {
          return null;
        }
        continue;
      }
      int parameter = Atom.parameterOf(term);
      if (bound[parameter] == Patterns.ANY && schema.domains().get(parameter).get(object)) {
        bound[parameter] = object;
      } else if (bound[parameter] != object) {
        return null;
      }
    }
    return bound;
  }

  private void addConditions(Schema schema, int[] binding) {
    for (Literal literal : schema.conditions()) {
      if (statics[literal.atom().symbol()] == null) {
        Atom pattern = pattern(literal.atom(), binding);
        Patterns patterns = literal.positive() ? holding : lacking;
        if (patterns.add(pattern)) {
          open.add(() -> achieve(pattern, literal.positive()));
        }
      }
    }
    for (Comparison comparison : schema.comparisons()) {
      addAmount(comparison.left(), binding);
      addAmount(comparison.right(), binding);
    }
    for (Atom added : schema.additions()) {
      if (spokes.isSpoke(added.symbol())) {
        Atom pattern = pattern(added, binding);
        if (entered.add(pattern)) {
          open.add(() -> release(pattern));
        }
      }
    }
  }

  private void addAmount(Amount amount, int[] binding) {
    if (amount instanceof Amount.Operation operation) {
      addAmount(operation.left(), binding);
      addAmount(operation.right(), binding);
    } else if (amount instanceof Amount.Value value) {
      Atom pattern = pattern(value.function(), binding);
      Atom shifted = new Atom(symbolOfFunction(pattern.symbol()), pattern.terms());
      if (holding.add(shifted)) {
        open.add(() -> change(pattern));
      }
    }
  }

  /** Every schema that can make the atoms of the pattern hold, or lack, matters. */
  private void achieve(Atom pattern, boolean positive) {
    for (Schema schema : task.schemas()) {
      patience.check();
      for (Atom effect : positive ? schema.additions() : schema.deletions()) {
        if (effect.symbol() == pattern.symbol()) {
          int[] bound = bind(schema, unbound(schema), effect, pattern.terms());
          if (bound != null) {
            use(schema, bound, effect, positive);
          }
        }
      }
    }
  }

  private void change(Atom function) {
    for (Schema schema : task.schemas()) {
      patience.check();
      for (Schema.Increase increase : schema.increases()) {
        if (increase.function().symbol() == function.symbol()) {
          int[] bound = bind(schema, unbound(schema), increase.function(), function.terms());
          if (bound != null) {
            need(schema, bound);
          }
        }
      }
    }
  }

  private void use(Schema schema, int[] binding, Atom effect, boolean positive) {
    Atom left = positive ? spokes.left(schema, effect).orElse(null) : null;
    if (left == null) {
      needOnce(schema, binding);
      return;
    }
    Waiting late = new Waiting(schema, binding, left);
    waiting.add(late);
    enteredOf(left.symbol()).forEach(atom -> tryRelease(late, atom));
  }

  private List<Atom> enteredOf(int symbol) {
    return released.stream().filter(atom -> atom.symbol() == symbol).toList();
  }

  private void release(Atom spoke) {
    released.add(spoke);
    for (Waiting late : List.copyOf(waiting)) {
      if (late.spoke().symbol() == spoke.symbol()) {
        tryRelease(late, spoke);
      }
    }
  }

  private void tryRelease(Waiting late, Atom spoke) {
    int[] bound = bind(late.schema(), late.binding(), late.spoke(), spoke.terms());
    if (bound != null) {
      needOnce(late.schema(), bound);
    }
  }

  private void needOnce(Schema schema, int[] binding) {
    List<Integer> key = new ArrayList<>(binding.length + 1);
    key.add(numberOf.get(schema));
    for (int object : binding) {
      key.add(object);
    }
    if (used.add(key)) {
      need(schema, binding);
    }
  }
}
