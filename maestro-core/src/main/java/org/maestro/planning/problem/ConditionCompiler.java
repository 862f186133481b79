package org.maestro.planning.problem;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import org.maestro.ontology.home.Geometry;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.planning.problem.Condition.Constant;
import org.maestro.planning.problem.Condition.Question;
import org.maestro.sl.Candidates;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/**
 * Makes ground conditions and number expressions of formulas: quantifiers and derived predicates
 * are expanded, what is static is decided by the facts.
 */
public final class ConditionCompiler {
  private static final int DEEPEST_DERIVATION = 50;

  /** So many individuals are tried sooner than it is found out which of them can matter. */
  private static final int FEW = 4;

  private final Signature signature;
  private final StaticFacts facts;
  private final Variables variables;
  private final boolean keepingFailed;
  private final Map<Formula.Atom, Condition> derived = new HashMap<>();
  private final Map<Formula.Atom, Condition> contraryToDerived = new HashMap<>();

  public ConditionCompiler(Signature signature, StaticFacts facts, Variables variables) {
    this(signature, facts, variables, false);
  }

  private ConditionCompiler(
      Signature signature, StaticFacts facts, Variables variables, boolean keepingFailed) {
    this.signature = signature;
    this.facts = facts;
    this.variables = variables;
    this.keepingFailed = keepingFailed;
  }

  /**
   * One that keeps what fails for good as {@link Condition.Fixed}, to be named in an explanation:
   * comparisons of stated numbers, stated facts that hamper, properties that a thing lacks. How
   * things stand to each other in space, and what they are, is taken as given.
   */
  public ConditionCompiler keepingFailed() {
    return new ConditionCompiler(signature, facts, variables, true);
  }

  /**
   * The ground condition.
   *
   * @param bindings values of the formula's free variables
   * @throws IllegalArgumentException when a free variable has no value
   */
  public Condition condition(Formula formula, Map<String, Term> bindings) {
    return compiled(formula, bindings, true, 0);
  }

  private Condition compiled(
      Formula formula, Map<String, Term> bindings, boolean positive, int depth) {
    if (formula instanceof Formula.Atom atom) {
      return atom(ground(atom, bindings), positive, depth);
    } else if (formula instanceof Formula.And and) {
      return joined(and.operands(), bindings, positive, depth, positive);
    } else if (formula instanceof Formula.Or or) {
      return joined(or.operands(), bindings, positive, depth, !positive);
    } else if (formula instanceof Formula.Not not) {
      return compiled(not.operand(), bindings, !positive, depth);
    } else if (formula instanceof Formula.Imply imply) {
      Formula or = new Formula.Or(List.of(new Formula.Not(imply.premise()), imply.conclusion()));
      return compiled(or, bindings, positive, depth);
    } else if (formula instanceof Formula.Exists exists) {
      return quantified(exists.variables(), exists.body(), bindings, positive, depth, !positive);
    } else if (formula instanceof Formula.Forall forall) {
      return quantified(forall.variables(), forall.body(), bindings, positive, depth, positive);
    } else if (formula instanceof Formula.Comparison comparison) {
      return comparison(comparison, bindings, positive);
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      return unknown(ground(unknown.atom(), bindings), positive);
    } else if (formula instanceof Formula.UnknownNumber unknown) {
      return unknownNumber(unknown.fluent(), bindings, positive);
    }
    return compiled(((Formula.Keep) formula).body(), bindings, positive, depth);
  }

  private Condition atom(Formula.Atom atom, boolean positive, int depth) {
    Formula definition = signature.definition(atom.predicate()).orElse(null);
    if (!signature.isDynamic(atom.predicate())) {
      boolean holds = (facts.truth(atom) == Truth.TRUE) == positive;
      if (holds || !keepingFailed || !isStatement(atom.predicate())) {
        return Constant.of(holds);
      } else if (definition == null) {
        return positive && atom.arguments().size() > 1
            ? Constant.FALSE
            : new Condition.Fixed(FixedObstacle.ofAtom(atom, positive));
      }
    }
    if (definition != null) {
      if (depth > DEEPEST_DERIVATION) {
        throw new IllegalArgumentException(
            "The derived predicate "
                + atom.predicate()
                + " is defined by itself; break the circle.");
      }
      return derived(atom, definition, positive, depth);
    }
    return literal(atom, positive ? Question.IS : Question.IS_NOT);
  }

  /** The same wherever the atom stands, and made once. */
  private Condition derived(Formula.Atom atom, Formula definition, boolean positive, int depth) {
    Map<Formula.Atom, Condition> known = positive ? derived : contraryToDerived;
    Condition condition = known.get(atom);
    if (condition == null) {
      condition = compiled(definition, parameterBindings(atom), positive, depth + 1);
      known.put(atom, condition);
    }
    return condition;
  }

  /** What cannot be changed may be otherwise from now on. */
  public void forget() {
    derived.clear();
    contraryToDerived.clear();
  }

  /** A word that homes and members state, neither a class nor computed of positions. */
  private boolean isStatement(String name) {
    return signature.declaration(name).filter(d -> d.computedBy().isEmpty()).isPresent()
        && !Geometry.isTruth(name)
        && !Geometry.isNumber(name);
  }

  private boolean isStatement(Expression expression) {
    if (expression instanceof Expression.Fluent fluent) {
      return isStatement(fluent.name()) || signature.declaration(fluent.name()).isEmpty();
    }
    return !(expression instanceof Expression.Arithmetic arithmetic)
        || arithmetic.operands().stream().allMatch(this::isStatement);
  }

  private Condition literal(Formula.Atom atom, Question question) {
    Variable variable = variables.variable(atom);
    return new Condition.Literal(variable, variables.value(atom, variable), question);
  }

  private Map<String, Term> parameterBindings(Formula.Atom atom) {
    List<TypedVariable> parameters =
        signature
            .declaration(atom.predicate())
            .map(PredicateDeclaration::parameters)
            .orElse(List.of());
    Map<String, Term> bindings = new HashMap<>();
    for (int i = 0; i < Math.min(parameters.size(), atom.arguments().size()); i++) {
      bindings.put(parameters.get(i).name(), atom.arguments().get(i));
    }
    return bindings;
  }

  /** Static operands first: they often decide the whole. */
  private Condition joined(
      List<Formula> operands,
      Map<String, Term> bindings,
      boolean positive,
      int depth,
      boolean conjunction) {
    Constant decisive = Constant.of(!conjunction);
    List<Condition> parts = new ArrayList<>();
    for (boolean dynamic : new boolean[] {false, true}) {
      for (Formula operand : operands) {
        if (signature.isDynamic(operand) == dynamic) {
          Condition part = compiled(operand, bindings, positive, depth);
          if (part == decisive) {
            return decisive;
          }
          parts.add(part);
        }
      }
    }
    return conjunction ? Condition.all(parts) : Condition.any(parts);
  }

  private Condition quantified(
      List<TypedVariable> quantified,
      Formula body,
      Map<String, Term> bindings,
      boolean positive,
      int depth,
      boolean conjunction) {
    List<Condition> parts = new ArrayList<>();
    choose(
        quantified,
        0,
        new HashMap<>(bindings),
        (variable, others) -> candidates(body, positive != conjunction, variable, others, depth),
        extended -> parts.add(compiled(body, extended, positive, depth)));
    return conjunction ? Condition.all(parts) : Condition.any(parts);
  }

  /**
   * Hands on the bindings extended by each choice of individuals for the variables.
   *
   * @param guard those with which it is false are left out, as far as that is told
   */
  void forEachGrounding(
      List<TypedVariable> quantified,
      Optional<Formula> guard,
      Map<String, Term> bindings,
      Consumer<Map<String, Term>> consumer) {
    choose(
        quantified,
        0,
        new HashMap<>(bindings),
        (variable, others) -> guard.flatMap(one -> candidates(one, variable, others)),
        consumer);
  }

  private void choose(
      List<TypedVariable> quantified,
      int next,
      Map<String, Term> bindings,
      BiFunction<String, Map<String, Term>, Optional<Set<Term>>> narrowing,
      Consumer<Map<String, Term>> consumer) {
    if (next == quantified.size()) {
      consumer.accept(bindings);
      return;
    }
    TypedVariable variable = quantified.get(next);
    List<Term> individuals = facts.individuals(variable.className().orElse(""));
    Optional<Set<Term>> among = Optional.empty();
    if (individuals.size() > FEW) {
      Map<String, Term> others = new HashMap<>(bindings);
      quantified.subList(next, quantified.size()).forEach(open -> others.remove(open.name()));
      among = narrowing.apply(variable.name(), others);
    }
    for (Term individual : individuals) {
      if (among.isEmpty() || among.get().contains(individual)) {
        bindings.put(variable.name(), individual);
        choose(quantified, next + 1, bindings, narrowing, consumer);
      }
    }
  }

  /**
   * The individuals for which the formula is not false whatever is done, where that can be told
   * without trying each.
   *
   * @param bindings values of the other variables; those of which nothing stands here are open
   */
  public Optional<Set<Term>> candidates(
      Formula formula, String variable, Map<String, Term> bindings) {
    return candidates(formula, true, variable, bindings, 0);
  }

  /** What fails is of interest where it is to be named. */
  private Optional<Set<Term>> candidates(
      Formula formula, boolean holding, String variable, Map<String, Term> bindings, int depth) {
    return keepingFailed
        ? Optional.empty()
        : new Candidates(index(depth)).of(formula, holding, variable, bindings);
  }

  private Candidates.Index index(int depth) {
    return new Candidates.Index() {
      @Override
      public Optional<Set<Term>> candidates(Formula.Atom atom, String open) {
        return ConditionCompiler.this.candidates(atom, open, depth);
      }

      @Override
      public Optional<Set<Term>> aboveZero(Expression.Fluent fluent, String open) {
        return signature.isDynamic(fluent.name())
            ? Optional.empty()
            : facts.aboveZero(fluent, open);
      }
    };
  }

  private Optional<Set<Term>> candidates(Formula.Atom atom, String variable, int depth) {
    boolean dynamic = signature.isDynamic(atom.predicate());
    Optional<Set<Term>> told = dynamic ? Optional.empty() : facts.candidates(atom, variable);
    Optional<Formula> definition = signature.definition(atom.predicate());
    if (told.isPresent() || definition.isEmpty() || depth > DEEPEST_DERIVATION) {
      return told;
    }
    Map<String, Term> bindings = parameterBindings(atom);
    String inside = "";
    for (Map.Entry<String, Term> binding : bindings.entrySet()) {
      inside = binding.getValue().isGround() ? inside : binding.getKey();
    }
    bindings.remove(inside);
    return candidates(definition.get(), true, inside, bindings, depth + 1);
  }

  private Condition comparison(
      Formula.Comparison comparison, Map<String, Term> bindings, boolean positive) {
    if (isOtherTerm(comparison.left(), bindings) || isOtherTerm(comparison.right(), bindings)) {
      boolean equal =
          comparison.relation() == Formula.Relation.EQUAL
              && comparison.left() instanceof Expression.OfTerm left
              && comparison.right() instanceof Expression.OfTerm right
              && ground(left.term(), bindings).equals(ground(right.term(), bindings));
      return Constant.of(equal == positive);
    }
    NumberExpression left = number(comparison.left(), bindings);
    NumberExpression right = number(comparison.right(), bindings);
    Condition.Compare compare = new Condition.Compare(comparison.relation(), left, right, positive);
    if (left instanceof NumberExpression.Constant a
        && right instanceof NumberExpression.Constant b) {
      boolean holds = compare.holdsFor(a.number(), b.number());
      return holds
              || !keepingFailed
              || !isStatement(comparison.left())
              || !isStatement(comparison.right())
          ? Constant.of(holds)
          : failed(comparison, bindings, positive, a.number(), b.number());
    }
    return compare;
  }

  private static Condition failed(
      Formula.Comparison comparison,
      Map<String, Term> bindings,
      boolean positive,
      double left,
      double right) {
    Formula ground = new Substitution(bindings).apply((Formula) comparison);
    return new Condition.Fixed(
        FixedObstacle.ofNumbers((Formula.Comparison) ground, positive, left, right));
  }

  private static boolean isOtherTerm(Expression expression, Map<String, Term> bindings) {
    return expression instanceof Expression.OfTerm ofTerm
        && !(ground(ofTerm.term(), bindings) instanceof Term.Number);
  }

  private Condition unknown(Formula.Atom atom, boolean positive) {
    if (!signature.isDynamic(atom.predicate())) {
      return Constant.of((facts.truth(atom) == Truth.UNKNOWN) == positive);
    }
    Variable variable =
        signature.definition(atom.predicate()).isPresent() ? null : variables.variable(atom);
    if (variable == null || !variable.observable()) {
      return Constant.of(!positive);
    }
    return literal(atom, positive ? Question.UNKNOWN : Question.NOT_UNKNOWN);
  }

  private Condition unknownNumber(
      Expression.Fluent fluent, Map<String, Term> bindings, boolean positive) {
    NumberExpression number = number(fluent, bindings);
    if (number instanceof NumberExpression.Read read) {
      return new Condition.NumberKnown(read.variable(), !positive);
    }
    double value = ((NumberExpression.Constant) number).number();
    return Constant.of(Quantity.isUnknown(value) == positive);
  }

  /** The ground expression; constant as far as it is static. */
  public NumberExpression number(Expression expression, Map<String, Term> bindings) {
    if (expression instanceof Expression.OfTerm ofTerm) {
      return new NumberExpression.Constant(
          ground(ofTerm.term(), bindings) instanceof Term.Number number
              ? number.value()
              : Quantity.UNKNOWN);
    } else if (expression instanceof Expression.Fluent fluent) {
      Expression.Fluent ground = ground(fluent, bindings);
      return signature.isDynamic(fluent.name())
          ? new NumberExpression.Read(variables.number(ground))
          : new NumberExpression.Constant(facts.number(ground));
    }
    Expression.Arithmetic arithmetic = (Expression.Arithmetic) expression;
    List<NumberExpression> operands =
        arithmetic.operands().stream().map(operand -> number(operand, bindings)).toList();
    NumberExpression operation = new NumberExpression.Operation(arithmetic.operator(), operands);
    return operands.stream().allMatch(NumberExpression::isConstant)
        ? new NumberExpression.Constant(operation.value(new NumberVector(new double[0])))
        : operation;
  }

  static Formula.Atom ground(Formula.Atom atom, Map<String, Term> bindings) {
    return new Formula.Atom(atom.predicate(), ground(atom.arguments(), bindings));
  }

  static Expression.Fluent ground(Expression.Fluent fluent, Map<String, Term> bindings) {
    return new Expression.Fluent(fluent.name(), ground(fluent.arguments(), bindings));
  }

  private static List<Term> ground(List<Term> terms, Map<String, Term> bindings) {
    Term[] ground = new Term[terms.size()];
    for (int i = 0; i < ground.length; i++) {
      ground[i] = ground(terms.get(i), bindings);
    }
    return List.of(ground);
  }

  private static Term ground(Term term, Map<String, Term> bindings) {
    if (!(term instanceof Term.Variable variable)) {
      return term;
    }
    Term value = bindings.get(variable.name());
    if (value == null) {
      throw new IllegalArgumentException(
          "The variable ?" + variable.name() + " has no value; bind it or quantify over it.");
    }
    return value;
  }
}
