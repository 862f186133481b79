package org.maestro.ontology.vocabulary;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.sl.Expression;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * The share that a fluent's number, times a setting, has in another number, so that it can be
 * learnt from what is measured: in the light of a location what a lamp gives it.
 *
 * @param number the number that has the share in it, {@code (illuminance ?z)}
 * @param setting how far is set what the share comes from, {@code (level ?l)}
 */
public record Share(Expression.Fluent number, Expression.Fluent setting) {

  Share with(Substitution called) {
    return new Share(called.apply(number), called.apply(setting));
  }

  /** Whether each argument of the fluent stands in the number or in the setting. */
  boolean tellsOfAll(List<TypedVariable> parameters) {
    return parameters.stream()
        .map(parameter -> new Term.Variable(parameter.name()))
        .allMatch(
            variable ->
                number.arguments().contains(variable) || setting.arguments().contains(variable));
  }

  /** The parameters of the fluent of which this number does not tell: those of its parts. */
  public Set<TypedVariable> open(List<TypedVariable> parameters) {
    return Set.copyOf(
        parameters.stream()
            .filter(p -> !number.arguments().contains(new Term.Variable(p.name())))
            .toList());
  }

  /**
   * The arguments that a ground number gives to the fluent, by name.
   *
   * @return empty when it is another number
   */
  public Optional<Map<String, Term>> in(Expression.Fluent ground) {
    if (!ground.name().equals(number.name())
        || ground.arguments().size() != number.arguments().size()) {
      return Optional.empty();
    }
    Map<String, Term> bindings = new HashMap<>();
    for (int n = 0; n < ground.arguments().size(); n++) {
      Term wanted = number.arguments().get(n);
      Term given = ground.arguments().get(n);
      Term same =
          wanted instanceof Term.Variable variable
              ? bindings.merge(variable.name(), given, (before, now) -> before)
              : wanted;
      if (!same.equals(given)) {
        return Optional.empty();
      }
    }
    return Optional.of(bindings);
  }
}
