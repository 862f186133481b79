package org.maestro.planning;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What a plan pays at least for other steps when it uses an operator: some step has to bring about
 * each condition that does not hold at first, and others before that one what it needs itself. What
 * no one feature can bring about together adds up.
 */
final class CostAhead implements ChainCosts.OffChain {
  /** So many steps in a row are looked at; more cost time, and tell little. */
  private static final int DEEPEST = 2;

  private static final double ROUNDING = 1e-9;

  /** Knows which instances of features bring a value about. */
  interface Source {
    List<Opening> openings(Aim aim);
  }

  /**
   * Instances of a feature that bring a value about.
   *
   * @param feature its number
   * @param price of the cheapest of them, at least
   * @param needs what all of them ask for
   */
  record Opening(int feature, double price, List<Condition.Literal> needs) {}

  private final Source source;
  private final List<Map<Aim, Way>> ways = new ArrayList<>();
  private final Map<Operator, Way> known = new HashMap<>();
  private final Set<Object> lookedAt = new HashSet<>();

  CostAhead(Source source) {
    this.source = source;
    for (int depth = 0; depth <= DEEPEST; depth++) {
      ways.add(new HashMap<>());
    }
  }

  @Override
  public Way ahead(Operator operator) {
    return known.computeIfAbsent(
        operator, absent -> all(literals(operator.precondition()), DEEPEST));
  }

  /** What comes before an instance. */
  Way of(Opening opening) {
    return all(opening.needs(), DEEPEST);
  }

  /** Only what comes right before: the steps before these may be those that lead to the leaf. */
  @Override
  public Way beside(Condition condition, Condition leaf) {
    if (!(leaf instanceof Condition.Literal literal)
        || literal.question() != Condition.Question.IS) {
      return Way.NOTHING;
    }
    Way own = way(new Aim(literal.variable(), literal.value()), 1);
    Way sum = Way.NOTHING;
    for (Way other : apart(literals(condition), 1)) {
      sum = own.isApartFrom(other) ? sum.and(other) : sum;
    }
    return sum;
  }

  /** The variables of which it mattered how they are at first. */
  Set<Object> lookedAt() {
    return lookedAt;
  }

  private static List<Condition.Literal> literals(Condition condition) {
    List<Condition.Literal> literals = new ArrayList<>();
    for (Condition part : condition.conjuncts()) {
      if (part instanceof Condition.Literal literal
          && literal.question() == Condition.Question.IS) {
        literals.add(literal);
      }
    }
    return literals;
  }

  private Way all(Collection<Condition.Literal> literals, int depth) {
    Way sum = Way.NOTHING;
    for (Way way : apart(literals, depth)) {
      sum = sum.and(way);
    }
    return sum;
  }

  /** Ways to those that do not hold at first which have no feature in common, the dearest first. */
  private List<Way> apart(Collection<Condition.Literal> literals, int depth) {
    List<Way> needed = new ArrayList<>();
    for (Condition.Literal literal : literals) {
      lookedAt.add(literal.variable());
      if (depth > 0 && !literal.holdsFor(literal.variable().initialCode())) {
        needed.add(way(new Aim(literal.variable(), literal.value()), depth));
      }
    }
    needed.sort(Comparator.comparingDouble(Way::cost).reversed());
    List<Way> apart = new ArrayList<>();
    for (Way way : needed) {
      if (way.cost() > 0 && apart.stream().allMatch(way::isApartFrom)) {
        apart.add(way);
      }
    }
    return apart;
  }

  /** The cost of the cheapest way to the aim, and all features that may be on such ways. */
  private Way way(Aim aim, int depth) {
    Way way = ways.get(depth).get(aim);
    if (way == null) {
      way = computed(aim, depth);
      ways.get(depth).put(aim, way);
    }
    return way;
  }

  private Way computed(Aim aim, int depth) {
    List<Opening> openings = source.openings(aim);
    List<List<Way>> before = new ArrayList<>();
    double least = Double.POSITIVE_INFINITY;
    for (Opening opening : openings) {
      List<Way> apart = apart(opening.needs(), depth - 1);
      before.add(apart);
      least = Math.min(least, opening.price() + apart.stream().mapToDouble(Way::cost).sum());
    }
    BitSet features = new BitSet();
    for (int i = 0; i < before.size(); i++) {
      features.set(openings.get(i).feature());
      double sum = openings.get(i).price();
      for (Way way : before.get(i)) {
        if (sum < least - ROUNDING) {
          sum += way.cost();
          features.or(way.features());
        }
      }
    }
    return new Way(least, features);
  }
}
