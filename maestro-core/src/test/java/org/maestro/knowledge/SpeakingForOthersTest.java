package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Dispute;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Expression;
import org.maestro.sl.Term;

/** The arena's one sensor stands in zone 2, and speaks for zones 1 and 3. */
class SpeakingForOthersTest {

  private final CollectiveKnowledge knowledge =
      new CollectiveKnowledge(
          new HomeLoader()
              .load(Path.of("../scenarios/assembly/src/main/resources/homes/arena.ttl")),
          new SteppedClock());

  @AfterEach
  void close() {
    knowledge.close();
  }

  @Test
  void ofTheZoneInWhichItStandsTheSensorIsSure() {
    measure("zone-2", 17);
    measure("zone-1", 17);

    assertThat(light("zone-2").confidence()).isEqualTo(1);
    assertThat(light("zone-1").confidence()).isEqualTo(0.4);
  }

  @Test
  void aRefusalWithAMeasuredValueCountsMoreThanASensorThatSpeaksFromElsewhere() {
    measure("zone-1", 105);
    refuse("cam-1", "zone-1", 26);
    measure("zone-1", 105);

    assertThat(light("zone-1").fact()).isEqualTo("(= (illuminance zone-1) 26)");
    assertThat(knowledge.snapshot().disputes())
        .flatExtracting(Dispute::losers)
        .extracting(loser -> loser.belief().source().agent(), Dispute.Loser::rule)
        .containsExactly(tuple("lux-1", Dispute.Rule.SURER));
  }

  @Test
  void whatTheLampsThereGiveIsNotTakenForLightHere() {
    knowledge.state(new Source(Source.Kind.STATED, "lamp-3"), List.of("(= (level lamp-3) 1)"));
    knowledge.state(new Source(Source.Kind.STATED, "lamp-4"), List.of("(= (level lamp-4) 0.5)"));
    measure("zone-3", 105);

    assertThat(lux("zone-3")).isCloseTo(17, within(12.0));
  }

  private void measure(String zone, double lux) {
    run("lux-1", "measureIllumination", zone, true, Map.of("lux", new Term.Number(lux)), List.of());
  }

  private void refuse(String camera, String zone, double lux) {
    run(
        camera,
        "observeObject",
        zone,
        false,
        Map.of(),
        List.of(new FeatureRun.Learnt("(illuminance %s)".formatted(zone), new Term.Number(lux))));
  }

  private void run(
      String member,
      String feature,
      String zone,
      boolean succeeded,
      Map<String, Term> outputs,
      List<FeatureRun.Learnt> refs) {
    FeatureType type =
        knowledge.home().devices().get(member).features().stream()
            .filter(f -> f.name().equals(feature))
            .findFirst()
            .orElseThrow();
    knowledge.learn(
        new FeatureRun(
            member,
            type,
            Map.of("zone", new Term.Name(zone), "object", new Term.Name("GreenObject")),
            succeeded,
            outputs,
            refs));
  }

  private Belief light(String zone) {
    return knowledge.snapshot().belief(illuminance(zone)).orElseThrow();
  }

  private double lux(String zone) {
    return knowledge.snapshot().number(illuminance(zone)).orElseThrow();
  }

  private static Expression.Fluent illuminance(String zone) {
    return new Expression.Fluent("illuminance", List.of(new Term.Name(zone)));
  }
}
