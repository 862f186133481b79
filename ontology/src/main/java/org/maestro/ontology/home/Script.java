package org.maestro.ontology.home;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Body;
import org.maestro.sl.Expression;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.TypedVariable;

/**
 * An action script of a home: how something is done, step by step (ADE, 4.1; A58). It is stated as
 * a goal by its name, with individuals or values for its parameters.
 *
 * @param name local name, unique among the words and things of the home
 * @param parameters in the order in which they are given; each has a class or datatype
 * @param benefit of having it carried out, in seconds of work, over its parameters
 * @param chance that it succeeds, as long as it was never tried
 * @param allowed simulated time within which its urgency grows to the highest
 * @param action as which plans may use it; empty: its effect is not stated
 */
public record Script(
    String name,
    String label,
    List<TypedVariable> parameters,
    Body body,
    Optional<Expression> benefit,
    Optional<Double> chance,
    Optional<Duration> allowed,
    Optional<FeatureType> action) {
  /** The name under which all scripts take part in plans, as devices do under theirs. */
  public static final String PLANNED_AS = "scripts";

  public Script {
    parameters = List.copyOf(parameters);
  }

  /** One that plans do not use. */
  public Script(
      String name,
      String label,
      List<TypedVariable> parameters,
      Body body,
      Optional<Expression> benefit,
      Optional<Double> chance,
      Optional<Duration> allowed) {
    this(name, label, parameters, body, benefit, chance, allowed, Optional.empty());
  }

  /** One of which nothing else is said. */
  public Script(String name, List<TypedVariable> parameters, Body body) {
    this(name, name, parameters, body, Optional.empty(), Optional.empty(), Optional.empty());
  }

  /** What is said of its worth. */
  public StatedWorth worth() {
    return new StatedWorth(benefit, chance, allowed);
  }

  /** How it is stated as a goal, with variables where values are to stand. */
  public String form() {
    StringBuilder form = new StringBuilder("(" + name);
    parameters.forEach(parameter -> form.append(' ').append(SlPrinter.print(parameter)));
    return form.append(')').toString();
  }
}
