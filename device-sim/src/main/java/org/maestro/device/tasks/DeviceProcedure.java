package org.maestro.device.tasks;

import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
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

  abstract Estimate cost(CallParameters parameters);

  /**
   * The price of taking over a call that is under way: whatever it was planned to begin with, it
   * begins as things are now.
   */
  Estimate costFromNow(CallParameters parameters) {
    return cost(parameters);
  }

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
    Estimate estimate = estimate(parameters, this::cost);
    return amount(estimate).orElseGet(() -> none(estimate));
  }

  @Override
  public final Optional<CostAnswer> costIfAble(Map<String, Object> parameters) {
    return amount(estimate(parameters, this::costFromNow));
  }

  private static Estimate estimate(
      Map<String, Object> parameters, Function<CallParameters, Estimate> costing) {
    try {
      return costing.apply(new CallParameters(parameters));
    } catch (InvalidCallException e) {
      return impossible(() -> reason(e));
    }
  }

  private static Optional<CostAnswer> amount(Estimate estimate) {
    return estimate instanceof Estimate.Possible possible
        ? Optional.of(
            new CostAnswer(
                Optional.of(possible.seconds() + Prices.UNITS_PER_JOULE * possible.joules()),
                Optional.of(possible.seconds()),
                Optional.empty()))
        : Optional.empty();
  }

  private static CostAnswer none(Estimate estimate) {
    return new CostAnswer(
        Optional.empty(),
        Optional.empty(),
        estimate instanceof Estimate.Impossible impossible
            ? Optional.of(impossible.reason().get())
            : Optional.empty());
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

  static Estimate price(double seconds, double joules) {
    return new Estimate.Possible(seconds, joules);
  }

  static Estimate impossible(Supplier<String> reason) {
    return new Estimate.Impossible(reason);
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

  /** Goes on when the driver's command is done, unless the call is over meanwhile. */
  static Completion next(Execution execution, Runnable then) {
    return new Completion() {
      @Override
      public void done() {
        if (!execution.ended()) {
          then.run();
        }
      }

      @Override
      public void failed(String reason) {
        execution.fail(FeatureContext.broken(reason));
      }
    };
  }
}
