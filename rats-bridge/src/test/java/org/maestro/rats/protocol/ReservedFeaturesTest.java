package org.maestro.rats.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What the features that begin with a dollar sign are, and what some of them carry. */
class ReservedFeaturesTest {

  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final Offer OFFER = new Offer("c7", "pick", 2.5, 1.25);
  private static final Release RELEASE = new Release("c7", "The battery is low");

  private final Schemas schemas = new Schemas();

  @Test
  void areKnownByTheirWords() {
    for (ReservedFeature feature : ReservedFeature.values()) {
      assertThat(ReservedFeature.of(feature.word())).contains(feature);
    }
    assertThat(ReservedFeature.of("$safe")).contains(ReservedFeature.SAFE);
    assertThat(ReservedFeature.of("safe")).isEmpty();
    assertThat(ReservedFeature.of("$SAFE")).isEmpty();
    assertThat(ReservedFeature.of("$offer")).isEmpty();
  }

  @Test
  void thatOnlyAskAreThree() {
    assertThat(ReservedFeature.values())
        .filteredOn(ReservedFeature::isQuestion)
        .containsExactly(ReservedFeature.COST, ReservedFeature.DESCRIBE, ReservedFeature.PING);
  }

  @Test
  void carryOffersAndReleasesAsTheSchemaHasIt() {
    assertThat(faults("$offer", OFFER.parameters())).isZero();
    assertThat(Offer.of(OFFER.parameters())).contains(OFFER);
    assertThat(faults("$release", RELEASE.parameters())).isZero();
    assertThat(Release.of(RELEASE.parameters())).contains(RELEASE);
  }

  @Test
  void offersMayBeForNothing() {
    Offer free = new Offer("c7", "pick", 0, 0);
    assertThat(Offer.of(free.parameters())).contains(free);
    assertThat(Offer.of(with(OFFER.parameters(), "seconds", 0)))
        .contains(new Offer("c7", "pick", 2.5, 0));
  }

  @Test
  void offersWithoutADurationLastAsLongAsTheyCost() {
    for (Object unusable : new Object[] {-1, "1", true}) {
      assertThat(Offer.of(with(OFFER.parameters(), "seconds", unusable)))
          .contains(new Offer("c7", "pick", 2.5, 2.5));
    }
    Map<String, Object> silent = OFFER.parameters();
    silent.remove("seconds");
    assertThat(faults("$offer", silent)).isZero();
    assertThat(Offer.of(silent)).contains(new Offer("c7", "pick", 2.5, 2.5));
  }

  static Stream<Map<String, Object>> noOffers() {
    return Stream.concat(
        Stream.of("task", "f", "cost").map(field -> without(OFFER.parameters(), field)),
        Stream.of(
            with(OFFER.parameters(), "task", 7),
            with(OFFER.parameters(), "f", 7),
            with(OFFER.parameters(), "cost", "2.5"),
            with(OFFER.parameters(), "cost", -0.5)));
  }

  @ParameterizedTest
  @MethodSource("noOffers")
  void whatTheSchemaTakesForNoOfferIsNone(Map<String, Object> parameters) {
    assertThat(faults("$offer", parameters)).isPositive();
    assertThat(Offer.of(parameters)).isEmpty();
  }

  static Stream<Map<String, Object>> noReleases() {
    return Stream.of(
        without(RELEASE.parameters(), "task"),
        without(RELEASE.parameters(), "reason"),
        with(RELEASE.parameters(), "task", 7),
        with(RELEASE.parameters(), "reason", true));
  }

  @ParameterizedTest
  @MethodSource("noReleases")
  void whatTheSchemaTakesForNoReleaseIsNone(Map<String, Object> parameters) {
    assertThat(faults("$release", parameters)).isPositive();
    assertThat(Release.of(parameters)).isEmpty();
  }

  private int faults(String feature, Map<String, Object> parameters) {
    return schemas
        .faults("reserved.json#/$defs/" + feature + "-parameters", MAPPER.valueToTree(parameters))
        .size();
  }

  private static Map<String, Object> with(Map<String, Object> all, String field, Object value) {
    Map<String, Object> changed = new HashMap<>(all);
    changed.put(field, value);
    return changed;
  }

  private static Map<String, Object> without(Map<String, Object> all, String field) {
    Map<String, Object> changed = new HashMap<>(all);
    changed.remove(field);
    return changed;
  }
}
