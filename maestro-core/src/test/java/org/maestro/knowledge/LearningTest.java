package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.Store;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Expression;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

class LearningTest {

  private static final FeatureType LOOK =
      Household.feature(
          "(and (sense (in ?object ?zone)) (canSee ?self ?object))",
          """
          (and (when (= ?found true) (and (position ?object ?pose) (canSee ?self ?object)))
               (when (= ?found false) (and (not (canSee ?self ?object))
                 (forall (?z - Zone) (when (and (covers ?self ?z) (>= (illuminance ?z) 72))
                   (not (in ?object ?z)))))))\
          """);
  private static final FeatureType LIGHT =
      Household.feature(
          """
          (and (assign (level ?self) ?level)
               (forall (?z - Zone) (when (= ?z zone-b)
                 (increase (illuminance ?z) (* 30 (- ?level (level ?self)))))))\
          """,
          "");
  private static final FeatureType PICK =
      Household.feature(
          "(and (in ?object ?self) (forall (?t - Thing) (not (nextTo ?object ?t))) (open ?self))",
          "");

  private static final FeatureType PUT = Household.feature("(in ?object ?zone)", "");

  private final Household home = new Household(store());

  /** Where the dataset is kept. */
  Store store() {
    return Store.IN_MEMORY;
  }

  @BeforeEach
  void light() {
    home.state(new Source(Source.Kind.OBSERVED, "lux-b"), "(= (illuminance zone-b) 80)");
    home.state(new Source(Source.Kind.STATED, "lamp-b1"), "(= (level lamp-b1) 0)");
  }

  @AfterEach
  void close() {
    home.close();
  }

  @Test
  void whatWasFoundIsWhereItWasSeen() {
    KnowledgeBase.Change change =
        succeed(
            "cam-b",
            LOOK,
            Map.of("object", name("Cup"), "zone", name("zone-b")),
            Map.of("found", new Term.Truth(true), "pose", new Term.Text("4 0 0")));

    assertThat(home.truth("(and (in Cup zone-b) (canSee cam-b Cup))")).isEqualTo(Truth.TRUE);
    assertThat(home.belief("(in Cup zone-b)")).map(Belief::source).contains(Household.CAMERA);
    assertThat(change.facts())
        .startsWith("(position Cup \"4 0 0\")", "(in Cup zone-b)")
        .contains("(canSee cam-b Cup)");
  }

  @Test
  void aDeviceWhoseClockIsOffByAnHourChangesNothing() {
    Map<String, Term> bindings = Map.of("object", name("Cup"), "zone", name("zone-b"));
    succeed("cam-b", LOOK, bindings, seen("4 0 0", "2026-01-01T01:00:00Z"));
    home.pass(Duration.ofSeconds(1));
    succeed("cam-a", LOOK, bindings, seen("1 0 0", "2025-12-31T23:00:00Z"));

    Belief place = home.belief("(in Cup zone-a)").orElseThrow();
    assertThat(place.source().agent()).as("received later").isEqualTo("cam-a");
    assertThat(place.age(home.clock.instant())).isZero();
    home.pass(Duration.ofMinutes(9));
    assertThat(home.truth("(in Cup zone-a)")).isEqualTo(Truth.TRUE);
    home.pass(Duration.ofMinutes(2));
    assertThat(home.truth("(in Cup zone-a)")).isEqualTo(Truth.UNKNOWN);
  }

  private static Map<String, Term> seen(String place, String timeOfItsOwn) {
    return Map.of(
        "found", new Term.Truth(true),
        "pose", new Term.Text(place),
        "time", new Term.Text(timeOfItsOwn));
  }

  @Test
  void whatWasNotFoundIsNotInWhatWasCovered() {
    succeed(
        "cam-b",
        LOOK,
        Map.of("object", name("Cup"), "zone", name("zone-b")),
        Map.of("found", new Term.Truth(false)));

    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.FALSE);
    assertThat(home.truth("(in Cup zone-a)")).isEqualTo(Truth.UNKNOWN);
    assertThat(home.truth("(canSee cam-b Cup)")).isEqualTo(Truth.FALSE);
  }

  @Test
  void whatACameraSawBeyondWhatItCoversIsNotThereWhenItSeesItNoMore() {
    Map<String, Term> bindings = Map.of("object", name("Cup"), "zone", name("zone-b"));
    succeed("cam-b", LOOK, bindings, seen("1 0 0", "2026-01-01T00:00:00Z"));
    assertThat(home.truth("(in Cup zone-a)")).isEqualTo(Truth.TRUE);
    home.pass(Duration.ofSeconds(5));

    succeed("cam-b", LOOK, bindings, Map.of("found", new Term.Truth(false)));

    assertThat(home.truth("(in Cup zone-a)")).isEqualTo(Truth.UNKNOWN);
    assertThat(home.knowledge.snapshot().value("position", List.of(name("Cup")))).isEmpty();
  }

  @Test
  void whatAnotherCameraSeesStaysWhereItIsSeen() {
    Map<String, Term> bindings = Map.of("object", name("Cup"), "zone", name("zone-b"));
    succeed("cam-b", LOOK, bindings, seen("1 0 0", "2026-01-01T00:00:00Z"));
    home.pass(Duration.ofSeconds(1));
    succeed("cam-a", LOOK, bindings, seen("1.1 0 0", "2026-01-01T00:00:00Z"));

    succeed("cam-b", LOOK, bindings, Map.of("found", new Term.Truth(false)));

    assertThat(home.truth("(in Cup zone-a)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void inTheDarkNothingIsExcluded() {
    home.state(new Source(Source.Kind.OBSERVED, "lux-b"), "(= (illuminance zone-b) 17)");
    succeed(
        "cam-b",
        LOOK,
        Map.of("object", name("Cup"), "zone", name("zone-b")),
        Map.of("found", new Term.Truth(false)));

    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.UNKNOWN);
  }

  @Test
  void anEffectIsReadBeforeTheStepThoughTheMemberSpokeFirst() {
    Snapshot before = home.knowledge.snapshot();
    home.state(new Source(Source.Kind.STATED, "lamp-b1"), "(= (level lamp-b1) 1)");
    home.knowledge.learn(
        new FeatureRun(
            "lamp-b1",
            LIGHT,
            Map.of("level", new Term.Number(1), "self", name("lamp-b1")),
            true,
            Map.of(),
            List.of(),
            Optional.of(before),
            true));

    assertThat(home.number("(illuminance zone-b)")).hasValue(110);
    assertThat(
            home.knowledge
                .snapshot()
                .belief(new Expression.Fluent("illuminance", List.of(name("zone-b")))))
        .map(Belief::source)
        .contains(new Source(Source.Kind.EXPECTED, "lamp-b1"));
    assertThat(
            home.knowledge
                .snapshot()
                .belief(new Expression.Fluent("level", List.of(name("lamp-b1")))))
        .as("its own word stands")
        .map(Belief::source)
        .contains(new Source(Source.Kind.STATED, "lamp-b1"));
  }

  @Test
  void whatAMemberTellsOfItselfStandsWhenItsStepFails() {
    home.state(new Source(Source.Kind.STATED, "rose"), "(in Cup rose)");
    home.knowledge.learn(
        new FeatureRun(
            "rose",
            PUT,
            Map.of("object", name("Cup"), "zone", name("zone-b"), "self", name("rose")),
            false,
            Map.of(),
            List.of()));

    assertThat(home.truth("(in Cup rose)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void whatASensorShowsAlreadyIsNotCountedTwice() {
    Snapshot before = home.knowledge.snapshot();
    home.state(new Source(Source.Kind.OBSERVED, "lux-b"), "(= (illuminance zone-b) 109)");

    lit(before);

    assertThat(home.number("(illuminance zone-b)")).hasValue(109);
  }

  @Test
  void aReadingFromBeforeTheLampLitDoesNotHideItsShare() {
    Snapshot before = home.knowledge.snapshot();
    home.state(new Source(Source.Kind.OBSERVED, "lux-b"), "(= (illuminance zone-b) 81)");

    lit(before);

    assertThat(home.number("(illuminance zone-b)")).hasValue(111);
  }

  @Test
  void whatOthersChangedMeanwhileLeavesOpenWhatTheLampDid() {
    Snapshot before = home.knowledge.snapshot();
    home.state(new Source(Source.Kind.OBSERVED, "lux-b"), "(= (illuminance zone-b) 200)");

    lit(before);

    assertThat(home.number("(illuminance zone-b)")).isEmpty();
    assertThat(home.number("(level lamp-b1)")).hasValue(1);
  }

  private void lit(Snapshot before) {
    home.knowledge.learn(
        new FeatureRun(
            "lamp-b1",
            LIGHT,
            Map.of("level", new Term.Number(1)),
            true,
            Map.of(),
            List.of(),
            Optional.of(before),
            true));
  }

  @Test
  void whatIsExpectedBelowTheLeastValueIsUnknown() {
    home.state(Household.CAMERA, "(= (illuminance zone-b) 20)");
    succeed("lamp-b1", LIGHT, Map.of("level", new Term.Number(-1)), Map.of());

    assertThat(home.number("(illuminance zone-b)")).isEmpty();
  }

  @Test
  void anUnknownNumberStaysUnknownWhenIncreased() {
    home.state(Household.CAMERA, "(unknown (illuminance zone-b))");
    succeed("lamp-b1", LIGHT, Map.of("level", new Term.Number(1)), Map.of());

    assertThat(home.number("(illuminance zone-b)")).isEmpty();
    assertThat(home.number("(level lamp-b1)")).hasValue(1);
  }

  @Test
  void aFailureTeachesItsReasonsAndLeavesWhatItMayHaveChangedUnknown() {
    home.state(Household.CAMERA, "(position Cup \"4 0 0\")");
    home.state(Household.CAMERA, "(position Bob \"4.1 0 0\")");
    home.knowledge.learn(
        new FeatureRun(
            "rose",
            PICK,
            Map.of("object", name("Cup"), "self", name("rose")),
            false,
            Map.of(),
            List.of(
                new FeatureRun.Learnt("(illuminance zone-b)", new Term.Number(16.5)),
                new FeatureRun.Learnt("(canSee cam-b Cup)", new Term.Truth(false)))));

    assertThat(home.number("(illuminance zone-b)")).hasValue(16.5);
    assertThat(home.truth("(canSee cam-b Cup)")).isEqualTo(Truth.FALSE);
    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.UNKNOWN);
    assertThat(home.truth("(nextTo Cup Bob)")).isEqualTo(Truth.UNKNOWN);
    assertThat(home.truth("(in Bob zone-b)")).as("another's place").isEqualTo(Truth.TRUE);
    assertThat(home.truth("(open rose)")).as("a plain fact").isEqualTo(Truth.FALSE);
  }

  /** A camera's old sight, heard late, spoke against the hand; then the hand refused. */
  @Test
  void aHandThatFailedIsBelievedWhatItSaysAllAlongThatItHolds() {
    home.state(Household.ROBOT, "(in Cup rose)");
    home.pass(Duration.ofSeconds(1));
    home.state(Household.CAMERA, "(position Cup \"4 0 0\")");
    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.TRUE);

    home.knowledge.learn(
        new FeatureRun(
            "rose",
            PICK,
            Map.of("object", name("Cup"), "self", name("rose")),
            false,
            Map.of(),
            List.of()));

    assertThat(home.truth("(in Cup rose)")).isEqualTo(Truth.TRUE);
    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.FALSE);
  }

  @Test
  void whatWasNotEvenBegunLeavesAllAsItWas() {
    home.state(Household.CAMERA, "(position Cup \"4 0 0\")");
    home.knowledge.learn(
        new FeatureRun(
            "rose",
            PICK,
            Map.of("object", name("Cup"), "self", name("rose")),
            false,
            Map.of(),
            List.of(),
            Optional.empty(),
            false));

    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void aFailedLampGoesOnTellingItsLevel() {
    home.knowledge.learn(
        new FeatureRun(
            "lamp-b1",
            LIGHT,
            Map.of("level", new Term.Number(1), "self", name("lamp-b1")),
            false,
            Map.of(),
            List.of()));

    assertThat(home.number("(level lamp-b1)")).hasValue(0);
    assertThat(home.number("(illuminance zone-b)")).isEmpty();
  }

  @Test
  void aPlacedThingIsExpectedWhereItWasPutUntilItIsSeen() {
    home.state(Household.CAMERA, "(position Bob \"4.1 0 0\")");
    FeatureType place =
        Household.feature(
            "(and (in ?object ?zone) (when (Thing ?target) (nextTo ?object ?target)))", "");
    succeed(
        "rose",
        place,
        Map.of("object", name("Cup"), "zone", name("zone-b"), "target", name("Bob")),
        Map.of());
    assertThat(home.belief("(nextTo Cup Bob)"))
        .map(belief -> belief.source().kind())
        .contains(Source.Kind.EXPECTED);

    home.state(Household.CAMERA, "(position Cup \"4.5 0 0\")");

    assertThat(home.belief("(nextTo Cup Bob)")).map(Belief::source).contains(Household.CAMERA);
  }

  private KnowledgeBase.Change succeed(
      String member, FeatureType feature, Map<String, Term> bindings, Map<String, Term> outputs) {
    return home.knowledge.learn(
        new FeatureRun(member, feature, bindings, true, outputs, List.of()));
  }

  private static Term.Name name(String text) {
    return new Term.Name(text);
  }
}
