package org.maestro.ontology.home;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;

/**
 * A parameter of a feature for which no plan can choose a value, as none are described: the feature
 * is in no plan, and that there is no plan is not proven by that.
 */
public record OpenChoice(String device, String feature, String parameter) {

  /** Of all devices of the home, in the order of their names. */
  public static List<OpenChoice> of(Home home) {
    return home.devices().values().stream()
        .flatMap(
            device ->
                device.features().stream()
                    .flatMap(
                        feature ->
                            in(feature).stream()
                                .map(
                                    parameter ->
                                        new OpenChoice(
                                            device.id(), feature.name(), parameter.name()))))
        .toList();
  }

  /** The first one that a feature has. */
  static Optional<Parameter> in(FeatureType feature) {
    return Stream.concat(feature.inputs().stream(), feature.binds().stream())
        .filter(parameter -> !parameter.optional() && !parameter.hasChoice())
        .findFirst();
  }

  /** What it means for a goal without a plan; one sentence. */
  public String sentence() {
    return "It is not known whether %s could do it by %s: nothing says which values %s may have; its description has to name them (oneOf)."
        .formatted(device, feature, parameter);
  }
}
