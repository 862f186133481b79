package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import jade.lang.acl.ACLMessage;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.agents.DeskAgent;
import org.maestro.assembly.SiteSettings;
import org.maestro.hal.Face;
import org.maestro.hal.FaceState;
import org.maestro.hal.FacialExpression;
import org.maestro.hal.Gaze;
import org.maestro.hal.HeadGesture;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Speaker;
import org.maestro.junit.Stage;
import org.maestro.junit.Unfinished;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sl.SlParser;

/**
 * The faces of rooms follow what is said: with a robot's head as with one that a page draws, which
 * the home's file says alone (ADE, 3.3 and 5; A41, A42, A90).
 */
class FacesTest {
  private static final String HEAD = "face";
  private static final String PAGE = "face-page";
  private static final String SCREEN = "screen-living";
  private static final AtomicInteger STAGES = new AtomicInteger();

  /** What the kitchen says in the living room, where its agent has no device of its own. */
  private static final String DELAY =
      """
      home:holdDinner a maestro:Script ; rdfs:label "ask whether dinner is to be later"@en ;
        maestro:arguments ( "?room - Zone" ) ;
        maestro:body \"""
          (seq (say ?room "Dinner is not in" microwave "yet.")
               (express stressed 0.6)
               (ask ?room "May I put" pasta "off by half an hour?" ?later boolean)
               (if (= ?later true)
                 (seq (express glad 0.8) (say ?room "Good, it will be ready in half an hour."))
                 (say ?room "Then I make haste.")))\""" .
      home:hurry a maestro:Script ; rdfs:label "say something late"@en ;
        maestro:benefit 60 ; maestro:allowed "PT100S"^^<http://www.w3.org/2001/XMLSchema#duration> ;
        maestro:body "(seq (say livingroom \\"In time.\\") (wait 80) (say livingroom \\"It is late.\\"))" .
      home:show a maestro:Script ; rdfs:label "show where the television is"@en ;
        maestro:body "(do pointAt screen-living :thing tv)" .
      """;

  private static Stage stage(String driver) {
    Home home =
        new HomeLoader()
            .load(
                text("/homes/rooms.ttl")
                        .replace(
                            "home:screen-living a :FaceScreen ;",
                            "home:screen-living a :Face ; maestro:driver \"" + driver + "\" ;")
                    + DELAY,
                "rooms.ttl");
    return Stage.stepped(
        SiteSettings.of("faces-" + STAGES.incrementAndGet(), home)
            .scene(SceneLoader.load("rooms.ttl", stream("/scenes/rooms.ttl"), home))
            .build());
  }

  private static String text(String path) {
    try (InputStream file = stream(path)) {
      return new String(file.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static InputStream stream(String path) {
    return Objects.requireNonNull(FacesTest.class.getResourceAsStream(path), path);
  }

  private static FaceState shown(Stage stage) {
    return stage.drivers(SCREEN).find(Face.class).orElseThrow().state();
  }

  private static FaceState await(Stage stage, String what, Predicate<FaceState> condition) {
    stage.await(what, () -> condition.test(shown(stage)));
    return shown(stage);
  }

  private static FaceState awaitSaying(Stage stage, String sentence) {
    return await(
        stage,
        sentence,
        face -> face.spoken().map(FaceState.Spoken::text).filter(sentence::equals).isPresent());
  }

  /** Somebody hears what the kitchen's agent does for a goal of its own, and answers it. */
  private static void kitchenPursues(Stage stage, String goal) {
    stage
        .platform()
        .desk()
        .request(
            ACLMessage.REQUEST,
            "kitchen-agent",
            DeskAgent.NO_END,
            reply -> {},
            SlParser.content("(initCNP (:goal " + goal + "))").get(0));
  }

  @ParameterizedTest
  @ValueSource(strings = {HEAD, PAGE})
  void theFaceLooksAtWhatIsDescribedNodsWhenItIsCertainAndSmilesWhenItIsDone(String driver) {
    try (Stage stage = stage(driver)) {
      Unfinished words =
          stage
              .speaker("Rose")
              .in("livingroom")
              .begins("turn on")
              .doesNotNod()
              .then("the ceiling light")
              .looksAt("living-lamp");
      Gaze gaze =
          await(stage, "it looks at the lamp", face -> face.gaze().isPresent())
              .gaze()
              .orElseThrow();
      assertThat(gaze.thing()).isEqualTo("living-lamp");
      assertThat(gaze.turn()).as("straight across the room").isCloseTo(0, within(1.0));
      assertThat(gaze.rise()).as("the lamp hangs higher than the face").isBetween(20.0, 35.0);
      await(stage, "it nods", face -> face.gesture().filter(HeadGesture.NOD::equals).isPresent());
      assertThat(shown(stage).persona()).isEqualTo("Living room");

      words.ends().isReached();
      await(stage, "it smiles", face -> face.expression() == FacialExpression.SMILE);
    }
  }

  @Test
  void itPointsAtAThingAndAnswersWhatIsNotUnderstoodWithAFrown() {
    try (Stage stage = stage(PAGE)) {
      Pursuit showing = stage.begin("(show)");
      FaceState face = await(stage, "it points", now -> now.pointing().isPresent());
      assertThat(face.pointing().orElseThrow().thing()).isEqualTo("tv");
      assertThat(face.gaze()).isEqualTo(face.pointing());
      assertThat(showing.await().reached()).isTrue();
      await(stage, "the hand is down", now -> now.pointing().isEmpty());

      stage.speaker("Rose").in("livingroom").says("fold the blorp").isRefused("blorp");
      FaceState sorry = await(stage, "it speaks", now -> now.spoken().isPresent());
      assertThat(sorry.expression()).isEqualTo(FacialExpression.FROWN);
      assertThat(sorry.spoken().orElseThrow().text()).contains("blorp");
      await(stage, "it is silent", now -> now.spoken().isEmpty());
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {HEAD, PAGE})
  void theKitchensAgentAppearsInTheLivingRoomToTellOfTheDelayOfDinner(String driver) {
    try (Stage stage = stage(driver)) {
      Speaker rose = stage.speaker("Rose").in("livingroom");
      kitchenPursues(stage, "(holdDinner livingroom)");

      FaceState first = awaitSaying(stage, "Dinner is not in the microwave yet.");
      assertThat(first.persona()).isEqualTo("Kitchen");
      assertThat(first.expression()).isEqualTo(FacialExpression.NEUTRAL);
      assertThat(first.gaze().map(Gaze::thing)).contains("microwave");
      assertThat(first.gaze().orElseThrow().turn()).as("to its left").isBetween(40.0, 47.0);

      String question = "May I put the pasta off by half an hour?";
      FaceState asking = awaitSaying(stage, question);
      assertThat(asking.persona()).isEqualTo("Kitchen");
      assertThat(asking.expression()).isEqualTo(FacialExpression.WORRY);
      assertThat(asking.intensity()).isEqualTo(0.6);
      assertThat(asking.spoken().orElseThrow().stress()).as("in the voice, too").isEqualTo(0.6);

      rose.awaits(question);
      rose.says("Yes.").isAnAnswer();
      String good = "Good, it will be ready in half an hour.";
      FaceState glad = awaitSaying(stage, good);
      assertThat(glad.persona()).isEqualTo("Kitchen");
      assertThat(glad.expression()).isEqualTo(FacialExpression.SMILE);
      assertThat(glad.spoken().orElseThrow().stress()).isZero();
      rose.awaits(good);

      rose.says("turn on the television").isReached();
      assertThat(await(stage, "it is another's", now -> !now.persona().equals("Kitchen")).persona())
          .isEqualTo("Living room");
    }
  }

  @Test
  void whoseTimeRunsOutSpeaksUnderStress() {
    try (Stage stage = stage(PAGE)) {
      stage.begin("(hurry)");
      FaceState calm = awaitSaying(stage, "In time.");
      assertThat(calm.spoken().orElseThrow().stress()).isZero();
      FaceState pressed = awaitSaying(stage, "It is late.");
      assertThat(pressed.spoken().orElseThrow().stress())
          .as("80 of 100 seconds are over")
          .isBetween(0.6, 0.65);
      assertThat(pressed.expression()).isEqualTo(FacialExpression.WORRY);
    }
  }

  @Test
  void whatAnotherRoomUnderstandsIsAnsweredByThatRoomsFaceHere() {
    try (Stage stage = stage(PAGE)) {
      stage
          .speaker("Rose")
          .in("livingroom")
          .says("Heat up the pasta from last night.")
          .isPassedOnTo("kitchen-agent")
          .isReached();
      FaceState face = await(stage, "it smiles", now -> now.expression() == FacialExpression.SMILE);
      assertThat(face.persona()).isEqualTo("Kitchen");
    }
  }
}
