package org.maestro.planning.ground;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.maestro.planning.ground.GroundTask.Bound;

/**
 * Gives numbers to facts, sums and bounds, and writes instances of schemas as operators of them.
 */
final class Numbering {
  /** So that sums of a thousand such numbers fit. */
  private static final BigDecimal MOST_UNITS = BigDecimal.valueOf(1_000_000_000_000_000L);

  private final LiftedTask task;
  private final Relation[] relations;
  private final boolean[] changing;
  private final GroundingBudget patience;
  private final int[] firstFact;
  private final int goalFact;
  private final Map<Integer, Integer> opposites = new LinkedHashMap<>();
  private final boolean[] changingFunctions;
  private final Map<Map<Atom, BigDecimal>, Integer> sums = new LinkedHashMap<>();
  private final List<Map<Atom, BigDecimal>> factorsOfSums = new ArrayList<>();
  private final List<BigDecimal> sumsAtFirst = new ArrayList<>();
  private final Map<Atom, List<Integer>> sumsOf = new HashMap<>();
  private final Map<OpenBound, Integer> bounds = new LinkedHashMap<>();
  private final BigDecimal coarsestUnit;
  private int facts;

  /** A bound before numbers are scaled; null where it is open. */
  private record OpenBound(
      int sum, @Nullable BigDecimal least, @Nullable BigDecimal most, boolean strict) {}

  /** An operator before numbers are scaled. */
  private record Draft(
      Instances.Instance instance,
      int[] bounds,
      BigDecimal cost,
      Map<Integer, BigDecimal> changes) {}

  /**
   * @param relations of changing predicates the tuples that may hold
   * @param coarsestUnit the unit of cost goes into 1 so often at least
   */
  Numbering(
      LiftedTask task,
      Relation[] relations,
      boolean[] changing,
      BigDecimal coarsestUnit,
      GroundingBudget patience) {
    this.coarsestUnit = coarsestUnit;
    this.task = task;
    this.relations = relations;
    this.changing = changing;
    this.patience = patience;
    firstFact = new int[relations.length];
    for (int symbol = 0; symbol < relations.length; symbol++) {
      firstFact[symbol] = facts;
      facts += changing[symbol] ? relations[symbol].size() : 0;
    }
    goalFact = facts++;
    changingFunctions = new boolean[task.functions().size()];
    for (Schema schema : task.schemas()) {
      schema.increases().forEach(i -> changingFunctions[i.function().symbol()] = true);
    }
  }

  /**
   * The task.
   *
   * @param isWhole whether there are no more instances, so that without one of the goal there is no
   *     plan
   */
  GroundTask number(List<Instances.Instance> instances, boolean isWhole) {
    boolean plainGoal = task.goals().size() == 1 && task.goals().get(0).domains().isEmpty();
    List<Draft> drafts = new ArrayList<>();
    List<int[]> boundsOf = new ArrayList<>();
    for (Instances.Instance instance : instances) {
      patience.check();
      Optional<int[]> kept = bounds(schema(instance), instance.binding());
      boundsOf.add(kept.orElse(null));
      findOpposites(schema(instance), instance.binding());
    }
    boolean reachable = false;
    int[] goal = {goalFact};
    int[] goalBounds = {};
    for (int i = 0; i < instances.size(); i++) {
      patience.check();
      Instances.Instance instance = instances.get(i);
      if (boundsOf.get(i) == null) {
        continue;
      }
      boolean ofGoal = task.isGoal(instance.schema());
      reachable |= ofGoal;
      if (ofGoal && plainGoal) {
        goal = needed(schema(instance), instance.binding());
        goalBounds = boundsOf.get(i);
      } else {
        draft(instance, boundsOf.get(i), ofGoal).ifPresent(drafts::add);
      }
    }
    return scaled(drafts, goal, goalBounds, isWhole && !reachable);
  }

  private Schema schema(Instances.Instance instance) {
    return task.schema(instance.schema());
  }

  /** The number of a ground atom that may hold and may matter, or -1. */
  private int fact(Atom atom, int[] binding) {
    if (!changing[atom.symbol()]) {
      return -1;
    }
    int number = relations[atom.symbol()].number(atom.ground(binding));
    return number < 0 ? -1 : firstFact[atom.symbol()] + number;
  }

  /** For what has to lack and could hold, a fact of its own says that it does not hold. */
  private void findOpposites(Schema schema, int[] binding) {
    for (Literal literal : schema.conditions()) {
      int fact = literal.positive() ? -1 : fact(literal.atom(), binding);
      if (fact >= 0 && !opposites.containsKey(fact)) {
        opposites.put(fact, facts++);
      }
    }
  }

  private int[] needed(Schema schema, int[] binding) {
    TreeSet<Integer> needed = new TreeSet<>();
    for (Literal literal : schema.conditions()) {
      int fact = fact(literal.atom(), binding);
      if (fact >= 0) {
        needed.add(literal.positive() ? fact : opposites.get(fact));
      }
    }
    return ints(needed);
  }

  private static int[] ints(SortedSet<Integer> numbers) {
    return numbers.stream().mapToInt(Integer::intValue).toArray();
  }

  /** The bounds that a schema's comparisons are; empty when one can never hold. */
  private Optional<int[]> bounds(Schema schema, int[] binding) {
    if (schema.comparisons().isEmpty()) {
      return Optional.of(new int[0]);
    }
    TreeSet<Integer> result = new TreeSet<>();
    for (Comparison comparison : schema.comparisons()) {
      Optional<LinearForm> left = form(comparison.left(), schema, binding);
      Optional<LinearForm> right = form(comparison.right(), schema, binding);
      if (left.isEmpty() || right.isEmpty()) {
        return Optional.empty();
      }
      LinearForm difference = left.get().minus(right.get());
      if (!difference.isConstant()) {
        result.add(bound(difference, comparison.relation()));
      } else if (!holds(difference.constant().signum(), comparison.relation())) {
        return Optional.empty();
      }
    }
    return Optional.of(ints(result));
  }

  private static boolean holds(int sign, Comparison.Relation relation) {
    return switch (relation) {
      case LESS -> sign < 0;
      case AT_MOST -> sign <= 0;
      case EQUAL -> sign == 0;
      case AT_LEAST -> sign >= 0;
      case MORE -> sign > 0;
    };
  }

  private int bound(LinearForm difference, Comparison.Relation relation) {
    boolean turned = difference.factors().values().iterator().next().signum() < 0;
    LinearForm form = turned ? difference.times(BigDecimal.ONE.negate()) : difference;
    int sum =
        sums.computeIfAbsent(
            form.factors(),
            factors -> {
              factors
                  .keySet()
                  .forEach(
                      function ->
                          sumsOf
                              .computeIfAbsent(function, absent -> new ArrayList<>())
                              .add(sums.size()));
              sumsAtFirst.add(
                  factors.entrySet().stream()
                      .map(e -> e.getValue().multiply(task.values().get(e.getKey())))
                      .reduce(BigDecimal.ZERO, BigDecimal::add));
              factorsOfSums.add(factors);
              return sums.size();
            });
    BigDecimal border = form.constant().negate();
    boolean strict = relation == Comparison.Relation.LESS || relation == Comparison.Relation.MORE;
    boolean atMost =
        relation == Comparison.Relation.LESS || relation == Comparison.Relation.AT_MOST;
    OpenBound bound =
        relation == Comparison.Relation.EQUAL
            ? new OpenBound(sum, border, border, false)
            : atMost != turned
                ? new OpenBound(sum, null, border, strict)
                : new OpenBound(sum, border, null, strict);
    return bounds.computeIfAbsent(bound, absent -> bounds.size());
  }

  private Optional<LinearForm> form(Amount amount, Schema schema, int[] binding) {
    try {
      return LinearForm.of(
          amount, binding, task.values(), function -> changingFunctions[function.symbol()]);
    } catch (GroundingException e) {
      throw e.at(schema.place());
    }
  }

  private Optional<Draft> draft(Instances.Instance instance, int[] kept, boolean ofGoal) {
    Schema schema = schema(instance);
    BigDecimal cost = task.metric().isEmpty() && !ofGoal ? BigDecimal.ONE : BigDecimal.ZERO;
    Map<Integer, BigDecimal> changes = new LinkedHashMap<>();
    for (Schema.Increase increase : schema.increases()) {
      Optional<LinearForm> amount = form(increase.amount(), schema, instance.binding());
      if (amount.isEmpty()) {
        return Optional.empty();
      }
      if (!amount.get().isConstant()) {
        throw new GroundingException(
                "%s changes a number by an amount that changes itself; this is not supported."
                    .formatted(schema.name()))
            .at(schema.place());
      }
      Atom function =
          new Atom(increase.function().symbol(), increase.function().ground(instance.binding()));
      BigDecimal change = amount.get().constant();
      BigDecimal weight = task.metric().get(function.symbol());
      if (weight != null) {
        cost = cost.add(weight.multiply(change));
      }
      for (int sum : sumsOf.getOrDefault(function, List.of())) {
        changes.merge(sum, change.multiply(factor(sum, function)), BigDecimal::add);
      }
    }
    if (cost.signum() < 0) {
      throw new GroundingException(
              "%s costs %s; costs below 0 are not supported."
                  .formatted(schema.name(), cost.toPlainString()))
          .at(schema.place());
    }
    changes.values().removeIf(change -> change.signum() == 0);
    return Optional.of(new Draft(instance, kept, cost, changes));
  }

  /** Of a function in one of the sums that have it. */
  private BigDecimal factor(int sum, Atom function) {
    return Objects.requireNonNull(factorsOfSums.get(sum).get(function));
  }

  private GroundTask scaled(List<Draft> drafts, int[] goal, int[] goalBounds, boolean unreachable) {
    List<BigDecimal> amounts = new ArrayList<>(sumsAtFirst);
    for (OpenBound bound : bounds.keySet()) {
      amounts.add(bound.least() == null ? BigDecimal.ZERO : bound.least());
      amounts.add(bound.most() == null ? BigDecimal.ZERO : bound.most());
    }
    for (Draft draft : drafts) {
      patience.check();
      amounts.addAll(draft.changes().values());
    }
    BigDecimal grain = Grounder.unit(amounts);
    patience.refuseIfOver();
    BigDecimal unit = Grounder.unit(drafts.stream().map(Draft::cost).toList()).max(coarsestUnit);
    List<Bound> scaledBounds = bounds.keySet().stream().map(bound -> scaled(bound, grain)).toList();
    patience.refuseIfOver();
    List<GroundOperator> operators = new ArrayList<>(drafts.size());
    for (Draft draft : drafts) {
      patience.check();
      operators.add(operator(draft, unit, grain));
    }
    return new GroundTask(
        facts,
        sumsAtFirst.stream().mapToLong(value -> units(value, grain)).toArray(),
        scaledBounds,
        operators,
        initialFacts(),
        goal,
        goalBounds,
        unit,
        unreachable,
        new FactNames(task, relations, changing, firstFact, opposites));
  }

  private static Bound scaled(OpenBound bound, BigDecimal grain) {
    int strict = bound.strict() ? 1 : 0;
    return new Bound(
        bound.sum(),
        bound.least() == null ? Long.MIN_VALUE : units(bound.least(), grain) + strict,
        bound.most() == null ? Long.MAX_VALUE : units(bound.most(), grain) - strict);
  }

  private static long units(BigDecimal value, BigDecimal unit) {
    BigDecimal units = value.multiply(unit).setScale(0, RoundingMode.HALF_EVEN);
    if (units.abs().compareTo(MOST_UNITS) > 0) {
      throw new GroundingException(
          "The number %s is too large, or other numbers are too fine beside it."
              .formatted(value.stripTrailingZeros()));
    }
    return units.longValueExact();
  }

  private GroundOperator operator(Draft draft, BigDecimal unit, BigDecimal grain) {
    Schema schema = schema(draft.instance());
    int[] binding = draft.instance().binding();
    TreeSet<Integer> added = new TreeSet<>();
    TreeSet<Integer> deleted = new TreeSet<>();
    for (Atom atom : schema.deletions()) {
      int fact = fact(atom, binding);
      if (fact >= 0) {
        deleted.add(fact);
        Optional.ofNullable(opposites.get(fact)).ifPresent(added::add);
      }
    }
    for (Atom atom : schema.additions()) {
      int fact = fact(atom, binding);
      if (fact >= 0) {
        added.add(fact);
        deleted.remove(fact);
        Integer opposite = opposites.get(fact);
        if (opposite != null) {
          added.remove(opposite);
          deleted.add(opposite);
        }
      }
    }
    if (task.isGoal(draft.instance().schema())) {
      added.add(goalFact);
    }
    SortedMap<Integer, BigDecimal> changes = new TreeMap<>(draft.changes());
    return new GroundOperator(
        draft.instance().schema(),
        binding,
        needed(schema, binding),
        ints(added),
        ints(deleted),
        draft.bounds(),
        changes.keySet().stream().mapToInt(Integer::intValue).toArray(),
        changes.values().stream().mapToLong(change -> units(change, grain)).toArray(),
        units(draft.cost(), unit));
  }

  private int[] initialFacts() {
    TreeSet<Integer> initial = new TreeSet<>(opposites.values());
    int[] nothing = {};
    for (Atom atom : task.initial()) {
      patience.check();
      int fact = fact(atom, nothing);
      if (fact >= 0) {
        initial.add(fact);
        Optional.ofNullable(opposites.get(fact)).ifPresent(initial::remove);
      }
    }
    return ints(initial);
  }
}
