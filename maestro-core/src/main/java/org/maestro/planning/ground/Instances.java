package org.maestro.planning.ground;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import java.util.PriorityQueue;
import org.jspecify.annotations.Nullable;
import org.maestro.planning.ground.Relation.Matches;

/**
 * The operators that can be reached when nothing that once held ceases to, and that may matter:
 * facts are taken one by one in the order of what they cost at least (the dearest condition of an
 * operator and the operator), each joined with those before it, so that every operator is found
 * once, and those that only dear plans can have are found last.
 */
final class Instances {
  /** A schema and its parameters' objects. */
  record Instance(int schema, int[] binding) {}

  private static final double TAKEN = -1;

  /** A fact that waits, at the cost that was known when it was added. */
  private record Fact(double cost, long sequence, int symbol, int number)
      implements Comparable<Fact> {
    @Override
    public int compareTo(Fact other) {
      int byCost = Double.compare(cost, other.cost);
      return byCost != 0 ? byCost : Long.compare(sequence, other.sequence);
    }
  }

  /** No schema is being joined yet. */
  private static final int NONE = -1;

  private final LiftedTask task;
  private final LeastCosts costs;
  private final Relation[] relations;
  private final boolean[] changing;
  private final Relevance relevant;
  private final Relation[] seen;

  /** Of each predicate what its seen tuples cost at least, or that they were taken. */
  private final double[][] costOf;

  private final PriorityQueue<Fact> queue = new PriorityQueue<>();
  private final List<Instance> instances = new ArrayList<>();
  private GroundingBudget patience;
  private long sequence;
  private double now;
  private boolean goalReached;
  private final List<Schema> schemas;

  private Schema schema;
  private int schemaNumber = NONE;
  private List<Atom> atoms = List.of();
  private boolean[] joined = {};
  private int[] binding = {};
  private int trigger;
  private int triggerFact;

  /**
   * @param relations of each predicate the tuples: those that never change are whole
   * @param changing the predicates that change
   */
  Instances(
      LiftedTask task,
      Relation[] relations,
      boolean[] changing,
      Relevance relevant,
      GroundingBudget patience) {
    this.task = task;
    this.relations = relations;
    this.changing = changing;
    this.relevant = relevant;
    this.patience = patience;
    this.seen = new Relation[relations.length];
    Arrays.setAll(seen, symbol -> new Relation(task.objects().size()));
    this.costOf = new double[relations.length][4];
    this.costs = new LeastCosts(task);
    this.schemas = new ArrayList<>(task.schemas());
    schemas.addAll(task.goals());
    this.schema = schemas.get(0);
    begin();
  }

  private void begin() {
    for (Atom atom : task.initial()) {
      patience.check();
      if (changing[atom.symbol()]) {
        reach(atom.symbol(), atom.terms(), 0);
      }
    }
    for (int number = 0; number < schemas.size(); number++) {
      if (schemas.get(number).conditions().stream().noneMatch(this::isChanging)) {
        start(number, -1, -1);
        extend(0);
      }
    }
  }

  /** All that was found; those of goals have the numbers after the last schema's. */
  List<Instance> found() {
    return instances;
  }

  /** The tuples of changing predicates that what was found may bring about, or that held. */
  Relation[] seen() {
    return seen;
  }

  /** Whatever was not found is in no plan that costs less; infinite when all was. */
  double beyond() {
    while (!queue.isEmpty() && isStale(queue.element())) {
      queue.remove();
    }
    return queue.isEmpty() ? Double.POSITIVE_INFINITY : queue.element().cost();
  }

  private boolean isStale(Fact fact) {
    return costOf[fact.symbol()][fact.number()] != fact.cost();
  }

  /**
   * Finds the operators that a plan of that cost may have, and at least so many that the goal is
   * reached.
   *
   * @throws java.util.concurrent.CancellationException when patience is over; then this is of no
   *     more use
   */
  void find(double cost, GroundingBudget until) {
    patience = until;
    double most = cost;
    while (beyond() < Double.POSITIVE_INFINITY && (!goalReached || beyond() <= most)) {
      Fact fact = queue.remove();
      costOf[fact.symbol()][fact.number()] = TAKEN;
      now = fact.cost();
      most = goalReached ? most : Math.max(most, now);
      int[] objects = seen[fact.symbol()].tuple(fact.number());
      int index = relations[fact.symbol()].add(objects);
      for (int number = 0; number < schemas.size(); number++) {
        List<Literal> conditions = schemas.get(number).conditions();
        int position = 0;
        for (Literal literal : conditions) {
          if (literal.positive()) {
            if (literal.atom().symbol() == fact.symbol()) {
              start(number, position, index);
              int[] trail = match(atoms.get(position), objects);
              if (trail != null) {
                joined[position] = true;
                extend(1);
              }
            }
            position++;
          }
        }
      }
    }
  }

  private boolean isChanging(Literal literal) {
    return literal.positive() && changing[literal.atom().symbol()];
  }

  private void reach(int symbol, int[] objects, double cost) {
    int number = seen[symbol].number(objects);
    if (number < 0) {
      if (!relevant.mayHaveToHold(symbol, objects) && !relevant.mayHaveToLack(symbol, objects)) {
        return;
      }
      number = seen[symbol].add(objects);
      if (number == costOf[symbol].length) {
        costOf[symbol] = Arrays.copyOf(costOf[symbol], 2 * number);
      }
    } else if (cost >= costOf[symbol][number]) {
      return;
    }
    costOf[symbol][number] = cost;
    queue.add(new Fact(cost, sequence++, symbol, number));
  }

  private void start(int number, int position, int fact) {
    if (schemaNumber != number) {
      schema = schemas.get(number);
      schemaNumber = number;
      atoms = schema.conditions().stream().filter(Literal::positive).map(Literal::atom).toList();
      joined = new boolean[atoms.size()];
      binding = new int[schema.domains().size()];
    }
    Arrays.fill(joined, false);
    Arrays.fill(binding, Patterns.ANY);
    trigger = position;
    triggerFact = fact;
  }

  /** Binds the atom's parameters to the objects; what was bound, or null when they do not fit. */
  private int @Nullable [] match(Atom atom, int[] objects) {
    int[] terms = atom.terms();
    int bound = 0;
    int[] trail = new int[terms.length];
    for (int i = 0; i < terms.length; i++) {
      int term = terms[i];
      if (term >= 0) {
        if (term != objects[i]) {
          undo(trail, bound);
          return null;
        }
        continue;
      }
      int parameter = Atom.parameterOf(term);
      if (binding[parameter] == Patterns.ANY && schema.domains().get(parameter).get(objects[i])) {
        binding[parameter] = objects[i];
        trail[bound++] = parameter;
      } else if (binding[parameter] != objects[i]) {
        undo(trail, bound);
        return null;
      }
    }
    if (!differencesHold()) {
      undo(trail, bound);
      return null;
    }
    return Arrays.copyOf(trail, bound);
  }

  private void undo(int[] trail, int bound) {
    for (int i = 0; i < bound; i++) {
      binding[trail[i]] = Patterns.ANY;
    }
  }

  private boolean differencesHold() {
    for (Schema.Sameness sameness : schema.differences()) {
      int first = Atom.value(sameness.first(), binding);
      int second = Atom.value(sameness.second(), binding);
      if (first >= 0 && second >= 0 && (first == second) != sameness.same()) {
        return false;
      }
    }
    return true;
  }

  /** Joins the atom with the fewest matches next. */
  private void extend(int done) {
    patience.check();
    if (done == atoms.size()) {
      bindOthers(0);
      return;
    }
    int best = -1;
    Matches fewest = null;
    for (int i = 0; i < joined.length; i++) {
      if (!joined[i]) {
        Atom atom = atoms.get(i);
        Matches matches = relations[atom.symbol()].matching(atom.ground(binding));
        if (fewest == null || matches.size() < fewest.size()) {
          fewest = matches;
          best = i;
          if (matches.size() == 0) {
            return;
          }
        }
      }
    }
    Atom atom = atoms.get(best);
    Relation relation = relations[atom.symbol()];
    boolean beforeTrigger =
        trigger >= 0 && best < trigger && atom.symbol() == atoms.get(trigger).symbol();
    joined[best] = true;
    int count = Objects.requireNonNull(fewest, "all are joined").size();
    int[] numbers = fewest.numbers();
    for (int i = 0; i < count; i++) {
      // The newest fact stands in the first of all places that it could stand in.
      if (beforeTrigger && numbers[i] == triggerFact) {
        continue;
      }
      int[] trail = match(atom, relation.tuple(numbers[i]));
      if (trail != null) {
        extend(done + 1);
        undo(trail, trail.length);
      }
    }
    joined[best] = false;
  }

  /** Parameters that no atom names may be any object of their types. */
  private void bindOthers(int from) {
    for (int parameter = from; parameter < binding.length; parameter++) {
      if (binding[parameter] == Patterns.ANY) {
        BitSet domain = schema.domains().get(parameter);
        for (int object = domain.nextSetBit(0);
            object >= 0;
            object = domain.nextSetBit(object + 1)) {
          binding[parameter] = object;
          if (differencesHold()) {
            bindOthers(parameter + 1);
          }
        }
        binding[parameter] = Patterns.ANY;
        return;
      }
    }
    finish();
  }

  private void finish() {
    for (Literal literal : schema.conditions()) {
      Atom atom = literal.atom();
      if (!literal.positive()
          && !changing[atom.symbol()]
          && relations[atom.symbol()].number(atom.ground(binding)) >= 0) {
        return;
      }
    }
    if (!differencesHold() || !task.isGoal(schemaNumber) && !isRelevant()) {
      return;
    }
    instances.add(new Instance(schemaNumber, binding.clone()));
    goalReached |= task.isGoal(schemaNumber);
    double reached = now + costs.of(schemaNumber, binding);
    for (Atom atom : schema.additions()) {
      reach(atom.symbol(), atom.ground(binding), reached);
    }
  }

  private boolean isRelevant() {
    for (Atom atom : schema.additions()) {
      if (relevant.mayHaveToHold(atom.symbol(), atom.ground(binding))) {
        return true;
      }
    }
    for (Atom atom : schema.deletions()) {
      if (relevant.mayHaveToLack(atom.symbol(), atom.ground(binding))) {
        return true;
      }
    }
    for (Schema.Increase increase : schema.increases()) {
      Atom function = increase.function();
      if (relevant.mayHaveToChange(function.symbol(), function.ground(binding))) {
        return true;
      }
    }
    return false;
  }
}
