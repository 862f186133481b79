package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.coordination.api.AnswerRefusal;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Respondent;
import org.maestro.coordination.api.Speech;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.home.Script;
import org.maestro.sl.AnswerFormat;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/** What scripts ask people, and which answers they take. */
class AskTest {
  private static Home home;

  private NarrowHouse house;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = AskTest.class.getResourceAsStream("/narrow.ttl")) {
      home =
          new HomeLoader()
              .load(
                  new String(turtle.readAllBytes(), StandardCharsets.UTF_8)
                      + """

                      home:Bob a :Person ; rdfs:label "Bob"@en .
                      home:Eve a :Person ; rdfs:label "Aunt Eve"@en .
                      """,
                  "narrow.ttl");
    }
  }

  private void begin(String body) {
    begin(body, Optional.empty());
  }

  private void begin(String body, Optional<Duration> deadline) {
    Script script = new Script("talk", List.of(), SlParser.body(body, home.vocabulary()::isFluent));
    house =
        new NarrowHouse(home.withScripts(Map.of("talk", script)), 1)
            .with("rose", "zone-a")
            .with("tim", "zone-c");
    house.wish("(talk)", 0, deadline);
    house.clock.run(Duration.ofSeconds(2));
  }

  private Optional<AnswerRefusal> answer(String part, String text) {
    List<Optional<AnswerRefusal>> told = new ArrayList<>();
    house.coordinator.answer(part, text, new Respondent("Bob"), told::add);
    assertThat(told).hasSize(1);
    house.clock.run(Duration.ofSeconds(1));
    return told.get(0);
  }

  private GoalOutcome outcome() {
    house.run(1, Duration.ofMinutes(5));
    assertThat(house.outcomes).as(house.told()).hasSize(1);
    return house.outcomes.get("G1");
  }

  @ParameterizedTest
  @CsvSource({
    "string, 'in the garden', '\"in the garden\"'",
    "boolean, Yes, true",
    "boolean, ' no ', false",
    "double, 21.5, 21.5",
    "decimal, -3, -3",
    "integer, 7, 7",
    "Person, Eve, Eve",
    "Person, aunt eve, Eve",
    "'(choice \"good\" \"so so\")', So so, '\"so so\"'",
    "'(choice \"good\" \"so so\")', ' 1 ', '\"good\"'",
    "'(choice Eve Bob \"nobody\")', aunt eve, Eve",
    "'(choice Eve Bob \"nobody\")', 2, Bob",
    "'(choice 10 5 2)', 2, 2",
    "'(slider 1 7 1)', 7, 7",
    "'(slider -1 1 0.1)', -0.3, -0.3",
  })
  void theVariableStandsForTheAnswer(String type, String text, String value) {
    begin("(seq (ask Bob \"Well?\" ?it %s) (return ?it))".formatted(type));

    assertThat(answer("G1.1", text)).isEmpty();

    assertThat(outcome().reached()).as(house.told()).isTrue();
    assertThat(outcome().binding()).containsOnlyKeys("result");
    assertThat(SlPrinter.print(outcome().binding().get("result"))).isEqualTo(value);
    assertThat(house.told())
        .contains("G1 SAID [1] Asks Bob: \"Well?\" ", "Answer by ./maestro answer G1.1,");
    assertThat(house.told()).contains("G1 KNOWN [1] ?it is " + value + ", as Bob has answered.");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "string  | ' '    | write some words.",
        "boolean | maybe  | write one of yes, no.",
        "double  | warm   | write a number, such as 21.5.",
        "double  | 1e999  | write a number, such as 21.5.",
        "integer | 2.5    | write a whole number, such as 3.",
        "Person  | rose   | write one of Bob, Eve.",
        "(choice \"good\" \"so so\") | 3 | write one of good, so so.",
        "(choice \"good\" Eve) | | write one of good, Aunt Eve.",
        "(choice 10 5 2) | 3 | write one of 10, 5, 2.",
        "(slider 1 7 1) | 8 | write a number from 1 to 7, by steps of 1.",
        "(slider 1 7 1) | very | write a number from 1 to 7, by steps of 1.",
        "(slider 0 1 0.25) | 0.3 | write a number from 0 to 1, by steps of 0.25.",
      })
  void anAnswerThatWouldNotDoIsToldSoAndTheQuestionStays(
      String type, @Nullable String said, String cure) {
    String text = said == null ? "" : said;
    begin("(seq (ask Bob \"Well?\" ?it %s) (return ?it))".formatted(type));

    assertThat(answer("G1.1", text))
        .contains(
            new AnswerRefusal(
                "G1.1 is not answered by \"%s\"; %s".formatted(text.strip(), cure), true));

    assertThat(house.outcomes).isEmpty();
    assertThat(house.state("G1")).isEqualTo(GoalState.WAITING);
    assertThat(house.status("G1").detail()).isEqualTo("step 1: for an answer of Bob to \"Well?\"");
  }

  @Test
  void whoIsAskedHearsTheQuestionWithAnswersThatWouldDo() {
    begin(
        "(let ?who (one (?p - Person) (Person ?p))"
            + " (ask ?who \"Shall\" rose \"come,\" ?who \"?\" ?yes boolean)"
            + " (ask ?who \"And who are you?\" ?name Person) (return ?name))");

    answer("G1.1.2.1", "yes");

    assertThat(house.letters.said)
        .containsExactly(
            new Speech(
                "G1.1.2.1",
                "Bob",
                "Shall rose come, Bob?",
                Optional.of(new Speech.Wanted("boolean", List.of("yes", "no")))),
            new Speech(
                "G1.1.2.1.1.1",
                "Bob",
                "And who are you?",
                Optional.of(new Speech.Wanted("Person", List.of("Bob", "Eve")))));
  }

  @Test
  void whoIsAskedHearsWhatCanBeChosenAndWhatCanBeSet() {
    begin(
        "(seq (ask Bob \"How was it?\" ?how (choice \"good\" rose))"
            + " (ask Bob \"And how\" ?how \"?\" ?much (slider 0 100 5 \"not at all\" \"\")) (return ?much))");

    answer("G1.1", "rose");
    answer("G1.1.1.1", "35");

    assertThat(house.letters.said)
        .extracting(Speech::wanted)
        .containsExactly(
            Optional.of(
                new Speech.Wanted(Speech.Wanted.CHOICE, List.of("good", "rose"), Optional.empty())),
            Optional.of(
                new Speech.Wanted(
                    Speech.Wanted.SLIDER,
                    List.of(),
                    Optional.of(new AnswerFormat.Slider(0, 100, 5, "not at all", "")))));
    assertThat(house.told())
        .contains("Asks Bob: \"How was it?\" One of: good, rose. Answer by")
        .contains("From 0 (not at all) to 100, by steps of 5. Answer by");
  }

  @Test
  void eachAnswerIsKeptWithWhoWasAskedWhatAndWhoseItIs() {
    begin("(seq (ask Bob \"Well?\" ?it (choice \"yes\" \"no\")) (ask Eve \"And you?\" ?n))");

    answer("G1.1", "maybe");
    answer("G1.1", "1");
    house.coordinator.answer(
        "G1.1.1.1", "so so", new Respondent("desk", Optional.of("Bob")), refusal -> {});

    assertThat(outcome().reached()).as(house.told()).isTrue();
    assertThat(house.letters.kept)
        .extracting(
            GivenAnswer::script,
            GivenAnswer::goal,
            GivenAnswer::part,
            GivenAnswer::to,
            GivenAnswer::person,
            GivenAnswer::question,
            GivenAnswer::answer)
        .containsExactly(
            tuple("talk", "(talk)", "G1.1", "Bob", "Bob", "Well?", "yes"),
            tuple("talk", "(talk)", "G1.1.1.1", "Eve", "Bob", "And you?", "so so"));
  }

  /** What does not need the answer goes on meanwhile; each question has its own answer. */
  @Test
  void twoQuestionsAreOpenSideBySide() {
    begin(
        "(par (ask Bob \"Where to?\" ?zone Zone (do move rose :to ?zone))"
            + " (ask Eve \"Where to?\" ?zone Zone (do move tim :to ?zone)))");

    assertThat(answer("G1.1.2", "zone-b")).isEmpty();
    house.clock.run(Duration.ofSeconds(30));
    assertThat(house.place).containsEntry("tim", "zone-b").containsEntry("rose", "zone-a");
    assertThat(house.state("G1")).isEqualTo(GoalState.WAITING);
    assertThat(answer("G1.1.2", "zone-c")).contains(AnswerRefusal.notOpen("G1.1.2"));

    assertThat(answer("G1.1.1", "zone-b")).isEmpty();
    assertThat(outcome().reached()).as(house.told()).isTrue();
    assertThat(house.place).containsEntry("rose", "zone-b");
  }

  @Test
  void whatIsCalledOffIsNotOpenAnyMore() {
    begin("(try (ask Bob \"Well?\" ?it (return ?it)) (finally (say Bob \"Never mind.\")))");

    house.coordinator.cancel("G1", "Bob");

    assertThat(outcome().state()).isEqualTo(GoalState.CANCELLED);
    assertThat(answer("G1.1.1", "yes")).contains(AnswerRefusal.notOpen("G1.1.1"));
    assertThat(house.letters.said).extracting(Speech::text).containsExactly("Well?", "Never mind.");
  }

  @Test
  void theDeadlineEndsTheWaiting() {
    begin("(ask Bob \"Well?\" ?it (return ?it))", Optional.of(Duration.ofSeconds(30)));

    assertThat(outcome().reasons()).first().asString().startsWith("Its deadline has passed");
    assertThat(answer("G1.1", "yes")).contains(AnswerRefusal.notOpen("G1.1"));
  }

  @Test
  void whoCannotBeAskedIsAReasonToFail() {
    Script script =
        new Script(
            "talk",
            List.of(),
            SlParser.body("(ask Bob \"Well?\" ?it)", home.vocabulary()::isFluent));
    house = new NarrowHouse(home.withScripts(Map.of("talk", script)), 1);
    house.letters.deaf.add("Bob");
    house.wish("(talk)");

    assertThat(outcome().reasons()).containsExactly("Bob is deaf.");
  }

  @Test
  void whatNobodyAsksIsNotAnswered() {
    begin("(ask Bob \"Well?\" ?it)");

    for (String part : List.of("", "G1", "G2.1", "G1.2", "rose-1.1")) {
      assertThat(answer(part, "yes")).contains(AnswerRefusal.notOpen(part));
    }
  }
}
