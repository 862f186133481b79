package org.maestro.sl;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Stream;

/** Facts from a list; atoms of the predicate "in" that are not listed are unknown, others false. */
final class TableOfFacts implements Facts {

  private final Map<Formula.Atom, Truth> truths = new LinkedHashMap<>();
  private final Map<Expression.Fluent, Double> numbers = new LinkedHashMap<>();
  private final List<Term.Name> individuals;

  TableOfFacts(List<String> individuals, String... facts) {
    this.individuals = individuals.stream().map(Term.Name::new).toList();
    Stream.of(facts).map(SlParser::fact).forEach(this::add);
  }

  private void add(Fact fact) {
    if (fact instanceof Fact.Holds holds) {
      truths.put(holds.atom(), Truth.TRUE);
    } else if (fact instanceof Fact.Excluded excluded) {
      truths.put(excluded.atom(), Truth.FALSE);
    } else if (fact instanceof Fact.Equation equation) {
      numbers.put(equation.fluent(), ((Term.Number) equation.value()).value());
    }
  }

  @Override
  public Truth truth(Formula.Atom atom) {
    return truths.getOrDefault(atom, atom.predicate().equals("in") ? Truth.UNKNOWN : Truth.FALSE);
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    Double number = numbers.get(fluent);
    return number == null ? OptionalDouble.empty() : OptionalDouble.of(number);
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    return individuals.stream()
        .filter(
            name ->
                className.isEmpty()
                    || truth(new Formula.Atom(className, List.of(name))) == Truth.TRUE)
        .toList();
  }
}
