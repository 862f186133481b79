package org.maestro.device.tasks;

import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.maestro.hal.Completion;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.protocol.CostAnswer;

/**
 * The start and the price of any procedure: faulty parameters become an answer, never a stack
 * trace. Clock thread only.
 */
abstract class DeviceProcedure implements Procedure {

  abstract void start(Execution execution, CallParameters parameters);

  abstract CostAnswer cost(CallParameters parameters);

  @Override
  public final void start(Execution execution) {
    try {
      start(execution, new CallParameters(execution.call().parameters()));
    } catch (InvalidCallException e) {
      execution.fail(FeatureContext.invalid(reason(e)));
    }
  }

  @Override
  public final CostAnswer cost(Map<String, Object> parameters) {
    try {
      return cost(new CallParameters(parameters));
    } catch (InvalidCallException e) {
      return impossible(reason(e));
    }
  }

  private static String reason(InvalidCallException e) {
    return Objects.requireNonNullElse(e.getMessage(), e.toString());
  }

  /**
   * A value set: the first of a continuous feature establishes it, that of any other is its result.
   */
  static void report(
      FeatureType feature, Execution execution, Map<String, Object> values, boolean first) {
    if (!feature.continuous()) {
      execution.succeed(values);
    } else if (first) {
      execution.established(values);
    } else {
      execution.observed(values);
    }
  }

  static CostAnswer price(double seconds, double joules) {
    return new CostAnswer(
        Optional.of(seconds + Prices.UNITS_PER_JOULE * joules),
        Optional.of(seconds),
        Optional.empty());
  }

  static CostAnswer impossible(String reason) {
    return new CostAnswer(Optional.empty(), Optional.empty(), Optional.of(reason));
  }

  /** Ends the call as the driver's command ends. */
  static Completion ending(Execution execution) {
    return new Completion() {
      @Override
      public void done() {
        execution.succeed(Map.of());
      }

      @Override
      public void failed(String reason) {
        execution.fail(FeatureContext.broken(reason));
      }
    };
  }
}
