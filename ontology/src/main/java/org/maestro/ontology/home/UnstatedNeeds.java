package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.Self;

/**
 * Numbers of devices that their features need, and that neither the home states nor anybody could
 * ever tell: such a feature is never used. No fault, since the device may be meant so, but hardly
 * ever what was wanted.
 */
public final class UnstatedNeeds {

  private final ToldNumbers told;

  private UnstatedNeeds(Home home) {
    this.told = new ToldNumbers(home);
  }

  /**
   * A number that a feature of a device needs.
   *
   * @param number the fluent's name
   */
  record Need(Device device, FeatureType feature, String number) {}

  /** A sentence for each, in the order of the devices. */
  public static List<String> of(Home home) {
    return all(home).stream()
        .map(
            need ->
                "%s offers %s, which needs its %s, and nothing states it; write it, or %s is never used for that."
                    .formatted(
                        need.device().id(),
                        need.feature().name(),
                        need.number(),
                        need.device().id()))
        .toList();
  }

  /** All of them, in the order of the devices. */
  static List<Need> all(Home home) {
    UnstatedNeeds needs = new UnstatedNeeds(home);
    List<Need> all = new ArrayList<>();
    for (Device device : home.devices().values()) {
      for (FeatureType feature : device.features()) {
        needs.unstated(device, feature).forEach(name -> all.add(new Need(device, feature, name)));
      }
    }
    return all;
  }

  private Set<String> unstated(Device device, FeatureType feature) {
    Set<String> names = new LinkedHashSet<>();
    Consumer<Expression.Fluent> noted =
        fluent -> {
          if (isOfSelf(fluent) && !isTold(device, fluent.name())) {
            names.add(fluent.name());
          }
        };
    for (Formula conjunct : conjuncts(feature.precondition())) {
      if (conjunct instanceof Formula.Comparison comparison) {
        Leaves.of(comparison, atom -> {}, noted);
      }
    }
    if (feature.cost() instanceof Price.Stated stated) {
      collect(stated.cost(), noted);
    }
    return names;
  }

  private static void collect(Expression expression, Consumer<Expression.Fluent> found) {
    if (expression instanceof Expression.Fluent fluent) {
      found.accept(fluent);
    } else if (expression instanceof Expression.Arithmetic arithmetic) {
      arithmetic.operands().forEach(operand -> collect(operand, found));
    }
  }

  private static List<Formula> conjuncts(Formula formula) {
    if (formula instanceof Formula.And and) {
      return and.operands().stream().flatMap(part -> conjuncts(part).stream()).toList();
    }
    return List.of(formula);
  }

  private static boolean isOfSelf(Expression.Fluent fluent) {
    return fluent.arguments().equals(List.of(Self.VARIABLE));
  }

  private boolean isTold(Device device, String name) {
    return told.isToldOf(device, name) || device.individual().properties().containsKey(name);
  }
}
