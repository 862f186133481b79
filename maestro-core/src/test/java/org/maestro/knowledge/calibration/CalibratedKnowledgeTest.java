package org.maestro.knowledge.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.home.NamedPoints;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Expression;
import org.maestro.sl.Point;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

class CalibratedKnowledgeTest {
  private static final double REST = 17;

  private final SteppedClock clock = new SteppedClock();
  private final CollectiveKnowledge kept =
      new CollectiveKnowledge(
          new HomeLoader().load(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl")),
          clock);
  private final CalibratedKnowledge knowledge = new CalibratedKnowledge(kept);

  @AfterEach
  void close() {
    kept.close();
  }

  private void pass(Duration time) {
    clock.runUntil(() -> false, time);
  }

  private void set(String lamp, double level) {
    knowledge.state(
        new Source(Source.Kind.STATED, lamp), List.of("(= (level %s) %s)".formatted(lamp, level)));
    pass(Duration.ofSeconds(1));
  }

  private void measure(double lux) {
    knowledge.learn(
        new FeatureRun(
            "lux-b",
            knowledge.home().vocabulary().features().get("measureIllumination"),
            Map.of("zone", new Term.Name("zone-b")),
            true,
            Map.of("lux", new Term.Number(lux)),
            List.of()));
    pass(Duration.ofSeconds(1));
  }

  private double gain(String lamp, String place) {
    Expression.Fluent fluent =
        (Expression.Fluent) SlParser.expression("(gain %s %s)".formatted(lamp, place));
    return knowledge.snapshot().number(fluent).orElseThrow();
  }

  private Optional<Belief> belief(String lamp, String place) {
    return knowledge
        .snapshot()
        .belief((Expression.Fluent) SlParser.expression("(gain %s %s)".formatted(lamp, place)));
  }

  private void allOff() {
    for (String lamp : List.of("lamp-b1", "lamp-b2", "lamp-b3")) {
      set(lamp, 0);
    }
  }

  private void learnThatLampB1GivesHalf() {
    allOff();
    measure(REST);
    set("lamp-b1", 1);
    measure(REST + 15);
    set("lamp-b1", 0);
    measure(REST);
  }

  @Test
  void whatALampGivesIsBelievedAsItWasMeasured() {
    assertThat(gain("lamp-b1", "zone-b")).isCloseTo(30, within(0.5));

    learnThatLampB1GivesHalf();

    assertThat(gain("lamp-b1", "zone-b")).isCloseTo(15, within(2.0));
    assertThat(belief("lamp-b1", "zone-b").orElseThrow().source())
        .isEqualTo(CalibratedKnowledge.SOURCE);
    assertThat(belief("lamp-b2", "zone-b")).isEmpty();
  }

  @Test
  void whatIsAsStatedIsNoNews() {
    List<String> news = new ArrayList<>();
    knowledge.watch(change -> news.addAll(change.facts()));
    allOff();
    for (int n = 0; n < 10; n++) {
      set("lamp-b1", n % 2);
      measure(REST + n % 2 * gain("lamp-b1", "zone-b") * (n % 3 == 0 ? 1.01 : 0.99));
    }

    assertThat(news).noneMatch(fact -> fact.contains("gain"));
  }

  @Test
  void aPointThatIsNamedLaterIsReckonedWithIt() {
    learnThatLampB1GivesHalf();
    NamedPoints points = new NamedPoints(Set.of(new Point(4.1, 1.5, 0.8)));
    knowledge.admit(points);
    double stated = gain("lamp-b1", "at_4.1_1.5_0.8");

    measure(REST);

    assertThat(gain("lamp-b1", "at_4.1_1.5_0.8")).isCloseTo(stated / 2, within(stated * 0.07));
  }

  @Test
  void whatWasMeasuredWhileALampWasSetTeachesNothing() {
    allOff();
    measure(REST);
    for (int n = 0; n < 4; n++) {
      knowledge.state(
          new Source(Source.Kind.STATED, "lamp-b1"),
          List.of("(= (level lamp-b1) %d)".formatted((n + 1) % 2)));
      measure(REST + 3);
    }

    assertThat(belief("lamp-b1", "zone-b")).isEmpty();
  }

  @Test
  void whatIsDoubtedCountsAsStatedUntilItIsLearntAnew() {
    learnThatLampB1GivesHalf();

    assertThat(knowledge.doubt(List.of("(nextTo Cup Bob)"))).isFalse();
    assertThat(knowledge.doubt(List.of("(>= (illuminance zone-b) 72)"))).isTrue();

    assertThat(gain("lamp-b1", "zone-b")).isCloseTo(30, within(0.5));
    assertThat(knowledge.doubt(List.of("(>= (illuminance zone-b) 72)"))).isFalse();
    learnThatLampB1GivesHalf();
    assertThat(gain("lamp-b1", "zone-b")).isCloseTo(15, within(2.0));
  }

  /** A camera looks into corners that the sensor does not know. */
  @Test
  void whatACameraIsToldOfItsLightIsLearntForIt() {
    allOff();
    measure(REST);
    for (double level : List.of(0.25, 1.0, 0.5, 1.0)) {
      set("lamp-b1", level);
      tooDarkForTheCamera(2 + level * 20);
    }
    assertThat(gain("lamp-b1", "zone-b")).isCloseTo(20, within(2.0));

    measure(REST + gain("lamp-b1", "zone-b"));

    assertThat(gain("lamp-b1", "zone-b")).isCloseTo(30, within(0.5));
  }

  private void tooDarkForTheCamera(double lux) {
    knowledge.learn(
        new FeatureRun(
            "cam-b",
            knowledge.home().vocabulary().features().get("observeObject"),
            Map.of("object", new Term.Name("Cup"), "zone", new Term.Name("zone-b")),
            false,
            Map.of(),
            List.of(
                new FeatureRun.Learnt(
                    "(illuminance zone-b)", new Term.Number(lux), Optional.of(">= 72")))));
    pass(Duration.ofSeconds(1));
  }

  @Test
  void aDayLaterItIsTriedAnew() {
    learnThatLampB1GivesHalf();
    pass(Duration.ofHours(25));

    measure(REST);

    assertThat(gain("lamp-b1", "zone-b")).isCloseTo(30, within(0.5));
  }

  @Test
  void aLampThatDescribesItselfOtherwiseIsLearntAnew() {
    learnThatLampB1GivesHalf();
    Device lamp = knowledge.home().devices().get("lamp-b1");
    knowledge.describe(brighter(lamp));

    measure(REST);

    assertThat(gain("lamp-b1", "zone-b")).isGreaterThan(50);
  }

  private static Device brighter(Device lamp) {
    Map<String, List<Term>> properties = new LinkedHashMap<>(lamp.individual().properties());
    properties.put("luminousIntensity", List.of(new Term.Number(1010)));
    Individual own = lamp.individual();
    return new Device(
        new Individual(own.name(), own.iri(), own.label(), own.classes(), properties),
        lamp.container(),
        lamp.driver(),
        lamp.features(),
        lamp.reports());
  }
}
