package org.maestro.coordination.api;

import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Script;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.planning.api.PricedFeature;

/** What plans are made from before anybody is asked: what stands in the descriptions. */
public final class DescribedFeatures {

  private DescribedFeatures() {}

  /**
   * The features that plans may use, at the prices that they have described.
   *
   * @param isThere which devices take part
   */
  public static List<PricedFeature> of(Home home, Predicate<String> isThere) {
    Stream<PricedFeature> ofDevices =
        home.devices().values().stream()
            .filter(device -> isThere.test(device.id()))
            .flatMap(device -> device.features().stream().map(type -> priced(device.id(), type)));
    Stream<PricedFeature> ofScripts =
        home.scripts().values().stream()
            .flatMap(script -> script.action().stream())
            .map(type -> priced(Script.PLANNED_AS, type));
    return Stream.concat(ofDevices, ofScripts).toList();
  }

  private static PricedFeature priced(String member, FeatureType type) {
    return new PricedFeature(member, type, type.cost(), Map.of());
  }
}
