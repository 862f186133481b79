package org.maestro.planning.problem;

import java.util.List;
import java.util.Map;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Term;

/**
 * A ground feature instance: a step that a plan may take.
 *
 * @param bindings values of inputs and binds by name, without {@code self}
 */
public record Operator(
    PricedFeature feature,
    Map<String, Term> bindings,
    Condition precondition,
    List<Change> changes,
    StepPrice price) {

  public StepKey key() {
    return new StepKey(feature.member(), feature.type().name(), bindings);
  }

  /** The changes in parts, some of which are the very same objects in other operators. */
  List<List<Change>> parts() {
    return JoinedChanges.parts(changes);
  }

  public Operator withChanges(List<Change> kept) {
    return new Operator(feature, bindings, precondition, List.copyOf(kept), price);
  }

  public Operator withPrecondition(Condition changed) {
    return new Operator(feature, bindings, changed, changes, price);
  }

  public Operator offered(PricedFeature other, StepPrice changed) {
    return new Operator(other, bindings, precondition, changes, changed);
  }

  public Operator withPrice(StepPrice changed) {
    return new Operator(feature, bindings, precondition, changes, changed);
  }

  /** An operator is itself only: comparing whole feature descriptions would be slow. */
  @Override
  public boolean equals(Object other) {
    return this == other;
  }

  @Override
  public int hashCode() {
    return System.identityHashCode(this);
  }
}
