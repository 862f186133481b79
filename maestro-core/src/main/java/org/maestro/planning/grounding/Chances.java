package org.maestro.planning.grounding;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.planning.problem.Condition.Constant;
import org.maestro.planning.problem.ConditionCompiler;
import org.maestro.planning.problem.Signature;
import org.maestro.planning.problem.Sought;
import org.maestro.planning.problem.StaticFacts;
import org.maestro.planning.problem.Variable;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/**
 * The probability of each value of a functional predicate that nobody knows. What was known last,
 * though too old to count, has the chance that the facts tell. The rest goes to the values that are
 * expected first ({@code likelyWhen}) and, a smaller part, to all others; within both by floor
 * area, since a thing may lie anywhere. What is excluded has none, and the others share it.
 */
public final class Chances {
  /** Part of the cases in which a thing is where it is expected first. Stated assumption. */
  static final double EXPECTED_FIRST = 0.8;

  private static final double SAME = 1e-9;

  private final Signature signature;
  private final StaticFacts facts;
  private final ConditionCompiler conditions;

  Chances(Signature signature, StaticFacts facts, ConditionCompiler conditions) {
    this.signature = signature;
    this.facts = facts;
    this.conditions = conditions;
  }

  /**
   * The chances of all values that are not excluded, in a stable order; they sum up to 1.
   *
   * @param asked values that a look can find
   */
  public Map<Term, Double> of(Variable variable, List<Term> asked) {
    List<Term> pool = pool(variable, asked);
    Map<Term, Double> chances = new LinkedHashMap<>();
    double still = pool.stream().mapToDouble(value -> still(variable, value)).sum();
    double sum = 0;
    for (Map.Entry<Term, Double> prior : prior(variable, pool).entrySet()) {
      Term value = prior.getKey();
      if (facts.truth(atom(variable, value)) == Truth.UNKNOWN) {
        double chance = still(variable, value) + Math.max(0, 1 - still) * prior.getValue();
        chances.put(value, chance);
        sum += chance;
      }
    }
    double all = sum;
    double alike = 1.0 / chances.size();
    chances.replaceAll((value, chance) -> all > 0 ? chance / all : alike);
    return chances;
  }

  /** The places, by their number among those that can be looked at, that are likeliest: alike. */
  public List<Integer> likeliest(Sought sought) {
    List<Term> terms = sought.terms();
    Map<Term, Double> chanceOf = of(sought.variable(), terms);
    double[] chance =
        terms.stream().mapToDouble(term -> chanceOf.getOrDefault(term, 0.0)).toArray();
    double most = Arrays.stream(chance).max().orElse(0);
    return IntStream.range(0, chance.length).filter(i -> chance[i] >= most - SAME).boxed().toList();
  }

  /** Whether something is likelier to be where nobody can look than anywhere else. */
  public boolean isLikelierOutOfView(Sought sought) {
    List<Term> inView = sought.terms();
    Map<Term, Double> chanceOf = of(sought.variable(), inView);
    double likeliest =
        inView.stream().mapToDouble(v -> chanceOf.getOrDefault(v, 0.0)).max().orElse(0);
    return chanceOf.entrySet().stream()
        .anyMatch(place -> !inView.contains(place.getKey()) && place.getValue() > likeliest + SAME);
  }

  private double still(Variable variable, Term value) {
    return facts.chanceStill(atom(variable, value));
  }

  /** All values that count: those with a floor, or where none has, those that are excluded. */
  private List<Term> pool(Variable variable, List<Term> asked) {
    Set<Term> pool = new LinkedHashSet<>(asked);
    boolean measured = asked.stream().allMatch(value -> area(value) > 0);
    String places = lastParameter(variable).flatMap(TypedVariable::className).orElse("");
    facts.individuals(places).stream()
        .filter(
            value -> measured ? area(value) > 0 : facts.truth(atom(variable, value)) == Truth.FALSE)
        .forEach(pool::add);
    return new ArrayList<>(pool);
  }

  /** Of each value, in the same order. */
  private Map<Term, Double> prior(Variable variable, List<Term> pool) {
    boolean measured = pool.stream().allMatch(value -> area(value) > 0);
    Map<Term, Double> sizes = new LinkedHashMap<>();
    Set<Term> first = new LinkedHashSet<>();
    double sizeOfFirst = 0;
    double sizeOfAll = 0;
    for (Term value : pool) {
      double size = measured ? area(value) : 1;
      sizes.put(value, size);
      sizeOfAll += size;
      if (isExpectedFirst(variable, value)) {
        first.add(value);
        sizeOfFirst += size;
      }
    }
    double sizeOfOthers = sizeOfAll - sizeOfFirst;
    double ofFirst = first.isEmpty() ? 0 : first.size() == pool.size() ? 1 : EXPECTED_FIRST;
    double sizeOfExpected = sizeOfFirst;
    Map<Term, Double> prior = new LinkedHashMap<>(sizes);
    prior.replaceAll(
        (value, size) ->
            first.contains(value)
                ? ofFirst * size / sizeOfExpected
                : (1 - ofFirst) * size / sizeOfOthers);
    return prior;
  }

  private boolean isExpectedFirst(Variable variable, Term value) {
    Optional<PredicateDeclaration> declaration = signature.declaration(variable.predicate());
    Optional<Formula> likely = declaration.flatMap(PredicateDeclaration::likelyWhen);
    if (likely.isEmpty()) {
      return false;
    }
    List<TypedVariable> parameters = declaration.get().parameters();
    Map<String, Term> bindings = new HashMap<>();
    for (int i = 0; i < variable.arguments().size(); i++) {
      bindings.put(parameters.get(i).name(), variable.arguments().get(i));
    }
    bindings.put(parameters.get(parameters.size() - 1).name(), value);
    return conditions.condition(likely.get(), bindings) == Constant.TRUE;
  }

  private Optional<TypedVariable> lastParameter(Variable variable) {
    return signature
        .declaration(variable.predicate())
        .map(PredicateDeclaration::parameters)
        .filter(parameters -> !parameters.isEmpty())
        .map(parameters -> parameters.get(parameters.size() - 1));
  }

  /** Square metres; not a positive number when the place has no floor. */
  private double area(Term place) {
    return facts.number(new Expression.Fluent("floorArea", List.of(place)));
  }

  private static Formula.Atom atom(Variable variable, Term value) {
    List<Term> all = new ArrayList<>(variable.arguments());
    all.add(value);
    return new Formula.Atom(variable.predicate(), all);
  }
}
