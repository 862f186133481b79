package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.hal.Face;
import org.maestro.hal.FaceState;
import org.maestro.hal.FacialExpression;
import org.maestro.hal.HeadGesture;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;

/**
 * One interface for a robot's head and for a face that a page draws: the driver is said by the home
 * file alone, and the same is true of both (ADE, 3.3; A41, A42).
 */
class FaceContractTest {
  private static final String HEAD = "face";
  private static final String PAGE = "face-page";
  private static final String SENTENCE = "One two three four five.";

  private static Homes withFace(String driver) {
    Home home =
        new HomeLoader()
            .load(
                Homes.text("bob")
                    + """
                    home:head a :Face ; rdfs:label "the face"@en ; maestro:driver "%s" ;
                      maestro:pose "1 1 1.5 90 0 0" .\
                    """
                        .formatted(driver),
                "bob.ttl");
    return new Homes(home, Homes.scene("bob-lit", home), 1);
  }

  private static FaceState shown(Homes homes) {
    return homes.simulated.drivers("head").find(Face.class).orElseThrow().state();
  }

  private static Map<String, Object> thing(double x, double y, double z) {
    return Map.of("ref", "https://w3id.org/maestro/home/bob#Cup", "position", List.of(x, y, z));
  }

  private static Result call(Homes homes, String feature, Map<String, Object> parameters) {
    return homes.call("head", feature, parameters).result().orElseThrow();
  }

  private static void succeed(Homes homes, String feature, Map<String, Object> parameters) {
    Result result = call(homes, feature, parameters);
    assertThat(result.outcome()).as("%s: %s", feature, result).isEqualTo(Outcome.SUCCEEDED);
  }

  /** Begins it, and lets so much time pass. */
  private static void begin(
      Homes homes, String feature, Map<String, Object> parameters, Duration passes) {
    homes.link.call(
        "head", feature, parameters, Duration.ofSeconds(30), Optional.empty(), result -> {});
    homes.clock.run(passes);
  }

  @ParameterizedTest
  @ValueSource(strings = {HEAD, PAGE})
  void itSmilesAndFrownsUntilItIsToldOtherwise(String driver) {
    try (Homes homes = withFace(driver)) {
      assertThat(shown(homes)).isEqualTo(FaceState.AT_REST);
      succeed(homes, "express", Map.of("expression", "smile", "intensity", 0.5));
      homes.clock.run(Duration.ofMinutes(1));
      assertThat(shown(homes).expression()).isEqualTo(FacialExpression.SMILE);
      assertThat(shown(homes).intensity()).isEqualTo(0.5);
      succeed(homes, "express", Map.of("expression", "frown"));
      assertThat(shown(homes).expression()).isEqualTo(FacialExpression.FROWN);
      assertThat(shown(homes).intensity()).isEqualTo(1);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {HEAD, PAGE})
  void itLooksWhereTheThingIsFromWhereItHangs(String driver) {
    try (Homes homes = withFace(driver)) {
      // It looks along the y axis: what is at its left has a lesser x.
      succeed(homes, "lookAt", Map.of("thing", thing(0, 2, 1.5)));
      assertThat(shown(homes).gaze().orElseThrow().turn()).isCloseTo(45, within(1e-6));
      assertThat(shown(homes).gaze().orElseThrow().rise()).isCloseTo(0, within(1e-6));
      succeed(homes, "lookAt", Map.of("thing", thing(2, 1, 0.5)));
      assertThat(shown(homes).gaze().orElseThrow().turn()).isCloseTo(-90, within(1e-6));
      assertThat(shown(homes).gaze().orElseThrow().rise()).isCloseTo(-45, within(1e-6));
      assertThat(shown(homes).gaze().orElseThrow().thing()).isEqualTo("Cup");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {HEAD, PAGE})
  void itsMouthMovesForAsLongAsTheSentenceTakes(String driver) {
    try (Homes homes = withFace(driver)) {
      Map<String, Object> calm =
          Map.of("to", Homes.ref("Bob"), "text", SENTENCE, "persona", "Kitchen");
      begin(homes, "sayWithFace", calm, Duration.ofMillis(1900));
      assertThat(shown(homes).spoken().map(FaceState.Spoken::text)).contains(SENTENCE);
      assertThat(shown(homes).persona()).isEqualTo("Kitchen");
      homes.clock.run(Duration.ofMillis(200));
      assertThat(shown(homes).spoken()).isEmpty();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {HEAD, PAGE})
  void aStressedVoiceIsQuickerAndToldSo(String driver) {
    try (Homes homes = withFace(driver)) {
      Map<String, Object> stressed =
          Map.of(
              "to",
              Homes.ref("Bob"),
              "text",
              SENTENCE,
              "expression",
              "worry",
              "intensity",
              1,
              "stress",
              1);
      begin(homes, "sayWithFace", stressed, Duration.ofMillis(1000));
      assertThat(shown(homes).spoken().map(FaceState.Spoken::stress)).contains(1.0);
      assertThat(shown(homes).expression()).isEqualTo(FacialExpression.WORRY);
      homes.clock.run(Duration.ofMillis(1100));
      assertThat(shown(homes).spoken()).as("two seconds are enough, or more").isEmpty();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {HEAD, PAGE})
  void twoSentencesAreSaidOneAfterTheOtherEachAsItsOwnPersona(String driver) {
    try (Homes homes = withFace(driver)) {
      begin(
          homes,
          "sayWithFace",
          Map.of("to", Homes.ref("Bob"), "text", SENTENCE, "persona", "Kitchen"),
          Duration.ofMillis(1000));
      begin(
          homes,
          "sayWithFace",
          Map.of("to", Homes.ref("Bob"), "text", SENTENCE, "persona", "Bedroom"),
          Duration.ofMillis(500));
      assertThat(shown(homes).persona()).isEqualTo("Kitchen");
      homes.clock.run(Duration.ofMillis(1500));
      assertThat(shown(homes).persona()).isEqualTo("Bedroom");
      assertThat(shown(homes).spoken()).isPresent();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {HEAD, PAGE})
  void itNodsAndPointsAndIsStillAgain(String driver) {
    try (Homes homes = withFace(driver)) {
      begin(homes, "nod", Map.of(), Duration.ofMillis(400));
      assertThat(shown(homes).gesture()).contains(HeadGesture.NOD);
      homes.clock.run(Duration.ofSeconds(1));
      assertThat(shown(homes).gesture()).isEmpty();
      begin(homes, "pointAt", Map.of("thing", thing(0, 2, 1.5)), Duration.ofMillis(1500));
      assertThat(shown(homes).pointing().orElseThrow().thing()).isEqualTo("Cup");
      assertThat(shown(homes).gaze()).isEqualTo(shown(homes).pointing());
      homes.clock.run(Duration.ofSeconds(2));
      assertThat(shown(homes).pointing()).isEmpty();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {HEAD, PAGE})
  void allOfItIsToldOnTheBusAsItHappens(String driver) {
    try (Homes homes = withFace(driver)) {
      List<List<String>> told = new ArrayList<>();
      homes.link.watch(
          member ->
              member
                  .state()
                  .filter(state -> state.member().equals("head"))
                  .ifPresent(state -> told.add(state.values())));
      begin(
          homes,
          "sayWithFace",
          Map.of("to", Homes.ref("Bob"), "text", SENTENCE, "about", thing(0, 2, 1.5)),
          Duration.ofSeconds(4));
      assertThat(told)
          .anySatisfy(
              facts ->
                  assertThat(facts)
                      .contains(
                          "(isSaying head \"" + SENTENCE + "\")",
                          "(looksAt head Cup)",
                          "(= (gazeTurn head) 45)"));
      assertThat(told.get(told.size() - 1)).noneMatch(fact -> fact.startsWith("(isSaying"));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {HEAD, PAGE})
  void whatNoFaceCanIsRefusedInOneSentence(String driver) {
    try (Homes homes = withFace(driver)) {
      assertThat(problem(call(homes, "express", Map.of("expression", "grin"))))
          .isEqualTo("A face has no expression grin; it has neutral, smile, frown, worry.");
      assertThat(problem(call(homes, "lookAt", Map.of("thing", Homes.ref("Cup")))))
          .isEqualTo("It is not known where Cup is; have somebody look for it first.");
      assertThat(problem(call(homes, "sayWithFace", Map.of("to", Homes.ref("Bob"), "text", " "))))
          .isEqualTo("The parameter text is missing; it is a text.");
      assertThat(shown(homes)).isEqualTo(FaceState.AT_REST);
    }
  }

  private static String problem(Result result) {
    return result.error().orElseThrow().message();
  }

  @Test
  void aFaceOfAPageCanNothingWhereNoPageShowsIt() {
    try (Homes homes = withFace(PAGE)) {
      homes.simulated.facesAreShownBy(member -> false);
      assertThat(problem(call(homes, "express", Map.of("expression", "smile"))))
          .isEqualTo("no page shows this face; open face.html#head of the console");
      assertThat(shown(homes)).isEqualTo(FaceState.AT_REST);
      homes.simulated.facesAreShownBy("head"::equals);
      succeed(homes, "express", Map.of("expression", "smile"));
    }
  }

  @Test
  void aHeadWithADefectMotorSaysSo() {
    try (Homes homes = withFace(HEAD)) {
      homes.world().breakDown("head", "a motor is hot");
      assertThat(problem(call(homes, "nod", Map.of()))).contains("a motor is hot");
    }
  }
}
