package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeSettings;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.Store;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** The shipped vocabulary and home, with their own geometry. */
class BobsHomeKnowledgeTest {

  private static final Source ROSE = new Source(Source.Kind.STATED, "rose");

  private final CollectiveKnowledge knowledge =
      CollectiveKnowledge.open(
          new HomeLoader().load(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl")),
          new SteppedClock(),
          KnowledgeSettings.inMemory().with(store()));

  /** Where the dataset is kept. */
  Store store() {
    return Store.IN_MEMORY;
  }

  @AfterEach
  void close() {
    knowledge.close();
  }

  @Test
  void theMapAndTheDevicesAreKnownAndPeopleAndThingsAreNot() {
    assertThat(truth("(and (covers cam-a zone-a) (not (covers cam-a zone-b)))"))
        .isEqualTo(Truth.TRUE);
    assertThat(truth("(and (senses lux-b zone-b) (not (senses lux-b zone-a)))"))
        .isEqualTo(Truth.TRUE);
    assertThat(truth("(and (passable zone-a zone-b) (passable zone-b zone-a))"))
        .isEqualTo(Truth.TRUE);
    assertThat(number("(gain lamp-b1 zone-b)")).isCloseTo(30, within(0.5));
    assertThat(number("(gain lamp-b1 zone-a)")).isZero();
    assertThat(number("(pathLength zone-a zone-b)")).isBetween(3.0, 4.0);
    assertThat(truth("(in Cup zone-a)")).isEqualTo(Truth.UNKNOWN);
    assertThat(truth("(in Cup rose)")).isEqualTo(Truth.UNKNOWN);
    assertThat(truth("(handFree rose)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void aCarriedCupStaysInTheHandWhileItsCarrierDrives() {
    knowledge.state(
        ROSE, List.of("(in rose zone-b)", "(position rose \"4 1 0\")", "(in Cup rose)"));
    knowledge.state(
        ROSE, List.of("(in rose zone-a)", "(position rose \"2 1 0\")", "(in Cup rose)"));

    assertThat(truth("(and (in Cup rose) (in rose zone-a) (not (handFree rose)))"))
        .isEqualTo(Truth.TRUE);
  }

  @Test
  void whatWasInViewIsNotInViewWhenItIsTooDarkForThat() {
    Source sensor = new Source(Source.Kind.OBSERVED, "lux-b");
    knowledge.state(sensor, List.of("(= (illuminance zone-b) 100)"));
    knowledge.learn(
        new FeatureRun(
            "cam-b",
            knowledge.home().vocabulary().features().get("observeObject"),
            Map.of("object", new Term.Name("Cup"), "zone", new Term.Name("zone-b")),
            true,
            Map.of("found", new Term.Truth(true), "pose", new Term.Text("4.5 1.5 0")),
            List.of()));
    assertThat(truth("(canSee cam-b Cup)")).isEqualTo(Truth.TRUE);
    knowledge.state(sensor, List.of("(= (illuminance zone-b) 90)"));
    assertThat(truth("(canSee cam-b Cup)")).isEqualTo(Truth.TRUE);

    knowledge.state(sensor, List.of("(= (illuminance zone-b) 17)"));

    assertThat(truth("(canSee cam-b Cup)")).isNotEqualTo(Truth.TRUE);
    assertThat(truth("(in Cup zone-b)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void whatWasNotFoundSaysHowMuchOfThePlaceWasCovered() {
    FeatureType observe = knowledge.home().vocabulary().features().get("observeObject");
    knowledge.state(
        new Source(Source.Kind.OBSERVED, "lux-b"), List.of("(= (illuminance zone-b) 100)"));
    knowledge.learn(
        new FeatureRun(
            "cam-b",
            observe,
            Map.of("object", new Term.Name("Cup"), "zone", new Term.Name("zone-b")),
            true,
            Map.of("found", new Term.Truth(false)),
            List.of()));
    assertThat(covered("(in Cup zone-b)")).isBetween(0.95, 1.0);

    FeatureType look = knowledge.home().vocabulary().features().get("lookAround");
    knowledge.learn(lookAround(look, "zone-a", 0.97));
    assertThat(covered("(in Cup zone-a)")).isEqualTo(0.97);
  }

  @Test
  void aLookThatCoveredTooLittleRulesNothingOut() {
    FeatureType look = knowledge.home().vocabulary().features().get("lookAround");
    knowledge.learn(lookAround(look, "zone-a", 0.6));
    assertThat(truth("(in Cup zone-a)")).isEqualTo(Truth.UNKNOWN);
  }

  private static FeatureRun lookAround(FeatureType look, String zone, double covered) {
    return new FeatureRun(
        "rose",
        look,
        Map.of("object", new Term.Name("Cup"), "zone", new Term.Name(zone)),
        true,
        Map.of("found", new Term.Truth(false), "covered", new Term.Number(covered)),
        List.of());
  }

  private double covered(String atom) {
    return knowledge
        .snapshot()
        .belief((Formula.Atom) SlParser.formula(atom))
        .orElseThrow()
        .coveredShare()
        .orElseThrow();
  }

  @Test
  void aLampsEffectIsExpectedOnce() {
    FeatureType adjust = knowledge.home().devices().get("lamp-b1").features().get(0);
    knowledge.state(
        new Source(Source.Kind.OBSERVED, "lux-b"), List.of("(= (illuminance zone-b) 17)"));
    knowledge.state(new Source(Source.Kind.STATED, "lamp-b1"), List.of("(= (level lamp-b1) 0)"));
    Snapshot before = knowledge.snapshot();
    knowledge.state(new Source(Source.Kind.STATED, "lamp-b1"), List.of("(= (level lamp-b1) 1)"));

    knowledge.learn(
        new FeatureRun(
            "lamp-b1",
            adjust,
            Map.of("level", new Term.Number(1)),
            true,
            Map.of(),
            List.of(),
            Optional.of(before),
            true));

    assertThat(number("(illuminance zone-b)")).isCloseTo(47, within(0.5));
  }

  @Test
  void whatIsSeenBesideAPersonIsNextToHim() {
    Source camera = new Source(Source.Kind.OBSERVED, "cam-a");
    knowledge.state(camera, List.of("(position Bob \"1 1 0\")"));
    knowledge.state(camera, List.of("(position Cup \"1.4 1 0\")"));

    assertThat(truth("(and (in Cup zone-a) (nextTo Cup Bob))")).isEqualTo(Truth.TRUE);
    assertThat(truth("(in Cup zone-b)")).isEqualTo(Truth.FALSE);
  }

  @Test
  void aPositionThatIsNoneIsIgnored() {
    knowledge.state(ROSE, List.of("(position rose \"nowhere\")", "(in rose zone-b)"));

    assertThat(truth("(in rose zone-b)")).isEqualTo(Truth.TRUE);
    assertThat(knowledge.snapshot().value("position", List.of(new Term.Name("rose")))).isEmpty();
  }

  private Truth truth(String formula) {
    return new Question(knowledge.snapshot()).queryIf(SlParser.formula(formula));
  }

  private double number(String fluent) {
    return knowledge
        .snapshot()
        .number((Expression.Fluent) SlParser.expression(fluent))
        .orElseThrow();
  }
}
