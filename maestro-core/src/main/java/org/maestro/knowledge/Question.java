package org.maestro.knowledge;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import org.maestro.knowledge.api.Answer;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.NumberVariables;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * Answers {@code query-if} and {@code query-ref} from one snapshot. Immutable; any thread may ask.
 */
public final class Question {

  /** What a number is that nobody knows: to compare it with any is neither true nor false. */
  private static final Term NO_NUMBER = new Term.Number(Double.NaN);

  private final Snapshot snapshot;
  private final ReadingRights rights;

  public Question(Snapshot snapshot) {
    this(snapshot, ReadingRights.ALL);
  }

  /**
   * @param rights of whom it is answered: what only private facts name is nothing that she is told
   *     of; that the question itself is not in private words is for who calls to see to
   */
  public Question(Snapshot snapshot, ReadingRights rights) {
    this.snapshot = snapshot;
    this.rights = rights;
  }

  /**
   * Whether the formula holds; {@code UNKNOWN} differs from {@code FALSE}. Free variables are
   * existential.
   */
  public Truth queryIf(Formula formula) {
    return answerIf(formula).truth();
  }

  /**
   * As {@link #queryIf}, with the reasons; of an answer that is not true, those of all bindings.
   */
  public Answer answerIf(Formula formula) {
    Truth best = Truth.FALSE;
    List<Belief> because = new ArrayList<>();
    for (Map<String, Term> binding : candidates(formula)) {
      Answer answer = answer(formula, binding);
      if (answer.truth() == Truth.TRUE) {
        return answer;
      }
      because.addAll(answer.because());
      best = answer.truth() == Truth.UNKNOWN ? Truth.UNKNOWN : best;
    }
    return new Answer(best, Map.of(), because, snapshot.at());
  }

  /** As {@link #queryRef}, with the reasons for each. */
  public List<Answer> answerRef(Formula formula) {
    return candidates(formula).stream()
        .map(binding -> answer(formula, binding))
        .filter(answer -> answer.truth() == Truth.TRUE)
        .toList();
  }

  private Answer answer(Formula formula, Map<String, Term> binding) {
    List<Belief> because = new ArrayList<>();
    Truth truth = new Evaluation(snapshot.witnessed(because::add)).truth(formula, binding);
    Map<String, Term> told = new LinkedHashMap<>(binding);
    told.values().removeIf(NO_NUMBER::equals);
    return new Answer(truth, told, because, snapshot.at());
  }

  /**
   * All bindings of the free variables, by name without question mark, with which the formula is
   * known to hold. Individuals come in the home's order, then other values that are known; who is
   * equated with a number has its value. Without free variables: one empty binding when it holds.
   */
  public List<Map<String, Term>> queryRef(Formula formula) {
    return answerRef(formula).stream().map(Answer::binding).toList();
  }

  private List<Map<String, Term>> candidates(Formula formula) {
    Set<Term> values = new LinkedHashSet<>(snapshot.individuals(""));
    for (Belief belief : snapshot.beliefs()) {
      if (rights.mayReadFact(belief.fact())
          && SlParser.fact(belief.fact()) instanceof Fact.Holds holds) {
        values.addAll(holds.atom().arguments());
      }
    }
    stated(formula, values);
    Set<String> numbers = NumberVariables.of(formula);
    List<Map<String, Term>> bindings = List.of(new LinkedHashMap<>());
    for (String variable : FreeVariables.of(formula)) {
      if (!numbers.contains(variable)) {
        bindings = extended(bindings, variable, binding -> values);
      }
    }
    return withNumbers(bindings, formula, numbers);
  }

  /** What the home says of something, such as its title, that is no individual. */
  private void stated(Formula formula, Set<Term> values) {
    if (formula instanceof Formula.Atom atom) {
      atom.arguments().stream()
          .filter(Term.Variable.class::isInstance)
          .map(variable -> ((Term.Variable) variable).name())
          .filter(name -> FreeVariables.of(atom).equals(Set.of(name)))
          .forEach(name -> snapshot.candidates(atom, name).ifPresent(values::addAll));
    }
    formula.parts().forEach(part -> stated(part, values));
  }

  /** One number may be reckoned from another: those go first whose equations say all. */
  private List<Map<String, Term>> withNumbers(
      List<Map<String, Term>> given, Formula formula, Set<String> numbers) {
    Map<String, List<Expression>> equations = NumberVariables.equationsIn(formula);
    Set<String> open = new LinkedHashSet<>(FreeVariables.of(formula));
    open.retainAll(numbers);
    List<Map<String, Term>> bindings = given;
    while (!open.isEmpty()) {
      Set<String> unsaid = Set.copyOf(open);
      Predicate<Expression> isSaid =
          value -> FreeVariables.of(value).stream().noneMatch(unsaid::contains);
      String next =
          open.stream()
              .filter(
                  variable -> equations.getOrDefault(variable, List.of()).stream().anyMatch(isSaid))
              .findFirst()
              .orElse(open.iterator().next());
      List<Expression> said =
          equations.getOrDefault(next, List.of()).stream().filter(isSaid).toList();
      bindings = extended(bindings, next, binding -> numbers(said, binding));
      open.remove(next);
    }
    return bindings;
  }

  private Set<Term> numbers(List<Expression> expressions, Map<String, Term> binding) {
    Set<Term> values = new LinkedHashSet<>();
    for (Expression expression : expressions) {
      OptionalDouble number = new Evaluation(snapshot).number(expression, binding);
      values.add(number.isPresent() ? new Term.Number(number.getAsDouble()) : NO_NUMBER);
    }
    return values.isEmpty() ? Set.of(NO_NUMBER) : values;
  }

  private static List<Map<String, Term>> extended(
      List<Map<String, Term>> bindings,
      String variable,
      Function<Map<String, Term>, Set<Term>> values) {
    List<Map<String, Term>> extended = new ArrayList<>();
    for (Map<String, Term> binding : bindings) {
      for (Term value : values.apply(binding)) {
        Map<String, Term> with = new LinkedHashMap<>(binding);
        with.put(variable, value);
        extended.add(with);
      }
    }
    return extended;
  }
}
