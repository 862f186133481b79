package org.maestro.coordination.api;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.sl.Expression;
import org.maestro.sl.Term;

/**
 * Makes the parameters of a call: a member has no knowledge base, so a pointer brings what the
 * feature's input needs.
 */
public final class CallArguments {
  private static final String POSITION = "position";

  private final Home home;
  private final Snapshot snapshot;

  public CallArguments(Home home, Snapshot snapshot) {
    this.home = home;
    this.snapshot = snapshot;
  }

  /** The arguments that are bound, each with what its input needs of it. */
  public Map<String, Argument> of(FeatureType feature, Map<String, Term> bindings) {
    Map<String, Argument> arguments = new LinkedHashMap<>();
    feature.inputs().forEach(input -> add(arguments, input, bindings));
    feature.binds().forEach(bound -> add(arguments, bound, bindings));
    return arguments;
  }

  private void add(
      Map<String, Argument> arguments, Parameter parameter, Map<String, Term> bindings) {
    Term value = bindings.get(parameter.name());
    if (value != null) {
      arguments.put(parameter.name(), argument(parameter, value));
    }
  }

  private Argument argument(Parameter parameter, Term value) {
    Individual individual =
        value instanceof Term.Name name ? home.individuals().get(name.text()) : null;
    if (individual == null) {
      return new Argument(value, Optional.empty(), Map.of());
    }
    Map<String, List<Term>> properties = new TreeMap<>();
    for (String need : parameter.needs()) {
      known(need, individual).ifPresent(values -> properties.put(need, values));
    }
    return new Argument(value, Optional.of(individual.iri()), properties);
  }

  private Optional<List<Term>> known(String property, Individual individual) {
    Term.Name name = new Term.Name(individual.name());
    Optional<Term> current = snapshot.value(property, List.of(name));
    if (current.isPresent()) {
      return current.map(List::of);
    }
    if (home.vocabulary().isFluent(property)) {
      var number = snapshot.number(new Expression.Fluent(property, List.of(name)));
      if (number.isPresent()) {
        return Optional.of(List.of(new Term.Number(number.getAsDouble())));
      }
    }
    return Optional.ofNullable(individual.properties().get(property))
        .or(() -> property.equals(POSITION) ? positionOf(individual) : Optional.empty());
  }

  /** What is fixed is where its pose says. */
  private static Optional<List<Term>> positionOf(Individual individual) {
    return individual.properties().getOrDefault("pose", List.of()).stream()
        .filter(Term.Text.class::isInstance)
        .map(pose -> Pose.parse(((Term.Text) pose).value()))
        .map(
            pose ->
                List.<Term>of(new Term.Text("%s %s %s".formatted(pose.x(), pose.y(), pose.z()))))
        .findFirst();
  }
}
