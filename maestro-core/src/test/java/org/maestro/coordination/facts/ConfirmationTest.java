package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.Belief;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.PricedFeature;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/** What is still to be observed before a goal may be called reached. */
class ConfirmationTest {
  private final KnownHome bobs = KnownHome.ofBob();
  private final KnownHome workshop = KnownHome.workshop();

  private static Optional<Confirmation> needed(KnownHome home, String goal) {
    return needed(home, goal, home.clock.instant().minus(Duration.ofHours(1)));
  }

  private static Optional<Confirmation> needed(KnownHome home, String goal, Instant notBefore) {
    return Confirmation.needed(home.formula(goal), Map.of(), home.now(), home.home, notBefore);
  }

  @Test
  void whatWasSeenNeedsNoMore() {
    bobs.seen("cam-a", "(position Cup \"1 1 0\")", "(position Bob \"1 1.3 0\")");

    assertThat(needed(bobs, "(nextTo Cup Bob)")).isEmpty();
    assertThat(needed(bobs, "(and (in Cup zone-a) (in Bob zone-a))")).isEmpty();
    assertThat(needed(bobs, "(<= (distance Cup Bob) 1)")).isEmpty();
  }

  @Test
  void aDeedIsTheWordOfItsDoer() {
    bobs.told("rose", "(in rose zone-a)");
    bobs.seen("cam-a", "(position Bob \"1 1.3 0\")");
    bobs.done(bobs.step("rose", "place", "object=Cup", "target=Bob", "zone=zone-a"));

    Confirmation needed = needed(bobs, "(nextTo Cup Bob)").orElseThrow();

    assertThat(needed.things()).contains("Cup");
    assertThat(needed.reporters()).containsExactly("rose");
    assertThat(needed.facts()).isEmpty();
    assertThat(needed.numbers()).isEmpty();
    assertThat(needed.denials()).isEmpty();
    assertThat(needed.oldest()).isEmpty();
    assertThat(needed.isOnlyDisputed()).isFalse();
  }

  /** Bob has taken it along, and nobody knows where he is. */
  @Test
  void whoLooksWhereItWasPutAndDoesNotSeeItMissesIt() {
    bobs.told("rose", "(in rose zone-a)");
    bobs.seen("cam-a", "(position Bob \"1 1.3 0\")");
    bobs.done(bobs.step("rose", "place", "object=Cup", "target=Bob", "zone=zone-a"));
    bobs.pass(Duration.ofSeconds(1));
    bobs.seen("cam-a", "(not (in Bob zone-a))", "(not (in Cup zone-a))");

    assertThat(needed(bobs, "(nextTo Cup Bob)").orElseThrow().missed())
        .extracting(Belief::fact)
        .containsExactly("(not (in Cup zone-a))");
  }

  @Test
  void aNumberThatItsDoerReckonedIsToBeMeasured() {
    workshop.done(workshop.step("pump-1", "fill", "tank=Barrel"));

    Confirmation needed = needed(workshop, "(>= (amount Barrel) 95)").orElseThrow();

    assertThat(needed.numbers())
        .extracting(ConfirmationTest::text)
        .containsExactly("(amount Barrel)");
    assertThat(needed.reporters()).containsExactly("pump-1");
    assertThat(needed.things()).isEmpty();

    workshop.seen("gauge-1", "(= (amount Barrel) 99)");
    assertThat(needed(workshop, "(>= (amount Barrel) 95)")).isEmpty();
  }

  @Test
  void aFactThatNoPositionTellsIsToBeLookedAt() {
    workshop.done(workshop.step("motor-1", "shutHatch", "hatch=Lid"));

    Confirmation needed = needed(workshop, "(shut Lid)").orElseThrow();

    assertThat(needed.facts()).extracting(SlPrinter::print).containsExactly("(shut Lid)");
    assertThat(needed.reporters()).containsExactly("motor-1");

    workshop.seen("eye-1", "(shut Lid)");
    assertThat(needed(workshop, "(shut Lid)")).isEmpty();
  }

  @Test
  void whatIsNotToBeSoIsLookedAtToo() {
    workshop.done(workshop.step("motor-1", "openHatch", "hatch=Lid"));

    assertThat(needed(workshop, "(not (shut Lid))").orElseThrow().facts())
        .extracting(SlPrinter::print)
        .containsExactly("(shut Lid)");
  }

  @Test
  void whatWasSeenTooLongAgoIsSeenAgain() {
    workshop.seen("gauge-1", "(= (amount Barrel) 99)");
    Instant then = workshop.clock.instant();
    workshop.pass(Duration.ofSeconds(30));

    Confirmation needed =
        needed(workshop, "(>= (amount Barrel) 95)", workshop.clock.instant()).orElseThrow();

    assertThat(needed.oldest()).contains(then);
    assertThat(needed.reporters()).isEmpty();
    assertThat(needed(workshop, "(>= (amount Barrel) 95)", then)).isEmpty();
  }

  @Test
  void theOldestCounts() {
    workshop.seen("gauge-1", "(= (amount Barrel) 99)");
    Instant then = workshop.clock.instant();
    workshop.pass(Duration.ofSeconds(30));
    workshop.seen("eye-1", "(shut Lid)");
    workshop.pass(Duration.ofSeconds(30));

    for (String goal :
        List.of(
            "(and (>= (amount Barrel) 95) (shut Lid))",
            "(and (shut Lid) (>= (amount Barrel) 95))")) {
      assertThat(needed(workshop, goal, workshop.clock.instant()).orElseThrow().oldest())
          .contains(then);
    }
  }

  @Test
  void whatIsDerivedRestsOnWhatItIsDerivedFrom() {
    workshop.done(workshop.step("motor-1", "shutHatch", "hatch=Lid"));
    workshop.done(workshop.step("motor-1", "seal", "hatch=Lid"));

    assertThat(needed(workshop, "(safe Lid)").orElseThrow().facts())
        .extracting(SlPrinter::print)
        .containsExactly("(shut Lid)", "(sealed Lid)");
  }

  @Test
  void ofAlternativesTheFirstThatHoldsCounts() {
    workshop.done(workshop.step("motor-1", "shutHatch", "hatch=Lid"));
    workshop.seen("gauge-1", "(= (amount Barrel) 99)");

    assertThat(needed(workshop, "(or (sealed Lid) (>= (amount Barrel) 95) (shut Lid))")).isEmpty();
    assertThat(needed(workshop, "(or (shut Lid) (>= (amount Barrel) 95))")).isPresent();
  }

  @Test
  void quantifiersSpeakOfTheirThings() {
    workshop.done(workshop.step("motor-1", "shutHatch", "hatch=Lid"));

    for (String goal :
        List.of("(exists (?h - Hatch) (shut ?h))", "(forall (?h - Hatch) (shut ?h))")) {
      assertThat(needed(workshop, goal).orElseThrow().facts())
          .extracting(SlPrinter::print)
          .containsExactly("(shut Lid)");
    }
  }

  @Test
  void theGoalOfALookIsTheGoalAndToHaveSeenWhatItRestsOn() {
    workshop.done(workshop.step("motor-1", "shutHatch", "hatch=Lid"));
    workshop.done(workshop.step("pump-1", "fill", "tank=Barrel"));
    String goal = "(and (shut Lid) (>= (amount Barrel) 95))";

    assertThat(SlPrinter.print(needed(workshop, goal).orElseThrow().goal(workshop.formula(goal))))
        .isEqualTo("(and " + goal + " (measured%shut Lid) (measured%amount Barrel))");
  }

  @Test
  void aThingIsSeenWhereItIsNotTouchedForIt() {
    bobs.told("rose", "(in rose zone-a)");
    bobs.seen("cam-a", "(position Bob \"1 1.3 0\")");
    bobs.done(bobs.step("rose", "place", "object=Cup", "target=Bob", "zone=zone-a"));

    assertThat(
            SlPrinter.print(
                needed(bobs, "(nextTo Cup Bob)")
                    .orElseThrow()
                    .goal(bobs.formula("(nextTo Cup Bob)"))))
        .isEqualTo("(and (nextTo Cup Bob) (seen% Cup) (not (touched% Cup)))");
  }

  @Test
  void thoseWhoCouldSeeItAreKnownByTheirEffects() {
    workshop.done(workshop.step("motor-1", "shutHatch", "hatch=Lid"));
    workshop.done(workshop.step("pump-1", "fill", "tank=Barrel"));
    Confirmation both = needed(workshop, "(and (shut Lid) (>= (amount Barrel) 95))").orElseThrow();
    var gauge = workshop.feature("gauge-1", "gauge").effect();
    var inspect = workshop.feature("eye-1", "inspect").effect();
    var fill = workshop.feature("pump-1", "fill").effect();

    assertThat(both.canBeSeenBy(List.of(gauge, inspect))).isTrue();
    assertThat(both.canBeSeenBy(List.of(gauge, fill))).isFalse();
    assertThat(both.canBeSeenBy(List.of(inspect, fill))).isFalse();
    assertThat(both.canBeSeenBy(List.of())).isFalse();
  }

  @Test
  void aThingCanBeSeenByWhoeverSensesAtoms() {
    bobs.told("rose", "(in rose zone-a)");
    bobs.done(bobs.step("rose", "place", "object=Cup", "target=Bob", "zone=zone-a"));
    Confirmation needed = needed(bobs, "(in Cup zone-a)").orElseThrow();

    assertThat(needed.canBeSeenBy(List.of(bobs.feature("cam-a", "observeObject").effect())))
        .isTrue();
    assertThat(needed.canBeSeenBy(List.of(bobs.feature("lux-a", "measureIllumination").effect())))
        .isFalse();
  }

  /** What is in a cupboard is seen by nobody, and nobody has to search for who could. */
  @Test
  void nobodySeesIntoWhatHasAPlaceAndNoArea() {
    bobs.told("rose", "(in Cup lamp-a1)");
    Confirmation needed = needed(bobs, "(in Cup lamp-a1)").orElseThrow();

    assertThat(needed.canBeSeenBy(List.of(bobs.feature("cam-a", "observeObject").effect())))
        .isFalse();
  }

  @Test
  void whatAnEffectDoesToWhatWasObserved() {
    assertThat(extended(workshop, "gauge-1", "gauge"))
        .isEqualTo("(and (sense (amount ?tank)) (measured%amount ?tank))");
    assertThat(extended(workshop, "pump-1", "fill"))
        .isEqualTo("(and (assign (amount ?tank) 100) (not (measured%amount ?tank)))");
    assertThat(extended(workshop, "eye-1", "inspect"))
        .isEqualTo("(and (sense (shut ?hatch)) (seen% ?hatch) (measured%shut ?hatch))");
    assertThat(extended(workshop, "motor-1", "shutHatch"))
        .isEqualTo("(and (shut ?hatch) (not (measured%shut ?hatch)))");
    assertThat(extended(workshop, "motor-1", "openHatch"))
        .isEqualTo("(and (not (shut ?hatch)) (not (measured%shut ?hatch)))");
    assertThat(extended(bobs, "rose", "place"))
        .isEqualTo(
            "(and (and (in ?object ?zone) (touched% ?object))"
                + " (when (Thing ?target) (and (nextTo ?object ?target) (touched% ?object))))");
    assertThat(extended(bobs, "lux-a", "measureIllumination"))
        .isEqualTo(
            "(and (and (sense (illuminance ?zone)) (measured%illuminance ?zone))"
                + " (forall (?p - Location) (when (reckonedFrom ?p ?zone)"
                + " (and (sense (illuminance ?p)) (measured%illuminance ?p)))))");
  }

  /** What is learnt from a step must not speak of what only planning knows. */
  @Test
  void withoutThatAFeatureIsAsItsDeviceDescribedIt() {
    assertIsStripped(workshop, "gauge-1", "gauge");
    assertIsStripped(workshop, "pump-1", "fill");
    assertIsStripped(workshop, "eye-1", "inspect");
    assertIsStripped(workshop, "motor-1", "openHatch");
    assertIsStripped(bobs, "rose", "place");
    assertIsStripped(bobs, "lux-a", "measureIllumination");
  }

  private static void assertIsStripped(KnownHome home, String member, String feature) {
    FeatureType described = home.feature(member, feature);
    FeatureType extended = extended(home, described);
    assertThat(SlPrinter.print(extended.effect())).contains("%");
    assertThat(facts(Confirmation.described(extended).effect()))
        .isEqualTo(facts(described.effect()));
  }

  /** The conjunctions that extending has put around an effect say nothing. */
  private static String facts(Effect effect) {
    return SlPrinter.print(effect).replaceAll("\\(and |[()]", "");
  }

  private static String extended(KnownHome home, String member, String feature) {
    return SlPrinter.print(extended(home, home.feature(member, feature)).effect());
  }

  private static FeatureType extended(KnownHome home, FeatureType described) {
    PricedFeature priced =
        new PricedFeature("any", described, new Price.Stated(SlParser.expression("1")), Map.of());
    return Confirmation.extend(priced, home.vocabulary).type();
  }

  @Test
  void whatALookDoesIsInTheWordsOfPlanning() {
    Vocabulary words = Confirmation.extend(workshop.vocabulary);

    assertThat(words.predicates())
        .containsKeys("seen%", "touched%", "measured%shut", "measured%amount", "shut")
        .as("what is derived, or decided by positions, is seen otherwise")
        .doesNotContainKeys("measured%safe", "measured%in", "measured%nextTo");
    assertThat(words.predicate("measured%shut").orElseThrow().parameters())
        .isEqualTo(words.predicate("shut").orElseThrow().parameters());
    assertThat(words.predicate("measured%amount").orElseThrow().fluent()).isFalse();
  }

  private static String text(Expression.Fluent fluent) {
    return SlPrinter.print(fluent);
  }
}
