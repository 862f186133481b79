package org.maestro.knowledge.calibration;

import java.util.LinkedHashMap;
import java.util.Map;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.belief.FactReader;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Self;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * The numbers that a feature's result tells as they were measured, and not as reckoned from it; of
 * a failure those because of which it failed.
 */
final class DirectMeasurements {
  private final FeatureRun run;
  private final Substitution ground;
  private final Map<Expression.Fluent, Double> numbers = new LinkedHashMap<>();

  private DirectMeasurements(FeatureRun run) {
    this.run = run;
    this.ground = new Substitution(Self.is(run.member(), run.bindings()));
  }

  static Map<Expression.Fluent, Double> of(FeatureRun run) {
    DirectMeasurements measurements = new DirectMeasurements(run);
    if (run.succeeded()) {
      run.feature().learns().ifPresent(measurements::add);
    } else {
      run.refs().forEach(measurements::add);
    }
    return measurements.numbers;
  }

  private void add(Effect effect) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(this::add);
    } else if (effect instanceof Effect.Change change
        && change.assignment() == Effect.Assignment.ASSIGN
        && change.value() instanceof Expression.OfTerm value
        && value.term() instanceof Term.Variable output
        && run.outputs().get(output.name()) instanceof Term.Number number) {
      numbers.put(ground.apply(change.fluent()), number.value());
    }
  }

  private void add(FeatureRun.Learnt ref) {
    if (FactReader.read(ref, run.member()) instanceof Fact.Equation equation
        && equation.value() instanceof Term.Number number) {
      numbers.put(equation.fluent(), number.value());
    }
  }
}
