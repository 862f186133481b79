package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.maestro.ontology.vocabulary.FeatureType;
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

  /** A sentence for each, in the order of the devices. */
  public static List<String> of(Home home) {
    UnstatedNeeds needs = new UnstatedNeeds(home);
    List<String> sentences = new ArrayList<>();
    for (Device device : home.devices().values()) {
      for (FeatureType feature : device.features()) {
        for (String name : needs.unstated(device, feature)) {
          sentences.add(
              "%s offers %s, which needs its %s, and nothing states it; write it, or %s is never used for that."
                  .formatted(device.id(), feature.name(), name, device.id()));
        }
      }
    }
    return sentences;
  }

  private Set<String> unstated(Device device, FeatureType feature) {
    Set<String> names = new LinkedHashSet<>();
    for (Formula conjunct : conjuncts(feature.precondition())) {
      if (conjunct instanceof Formula.Comparison comparison) {
        Leaves.of(
            comparison,
            atom -> {},
            fluent -> {
              if (isOfSelf(fluent) && !isTold(device, fluent.name())) {
                names.add(fluent.name());
              }
            });
      }
    }
    return names;
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
