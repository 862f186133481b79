package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;
import org.maestro.knowledge.Question;
import org.maestro.knowledge.QuestionReader;
import org.maestro.knowledge.api.Answer;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Source;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/**
 * The action script of ADE's section 5, as it is printed there, prepares a living room: its calls
 * go to whoever can do them there, in its order (ADE, 5; A75, A76), by what is known of persons
 * (ADE, 4.1; A57).
 */
class LivingRoomTest {

  /** What the script runs, what it is given, and what devices do for it, without the places. */
  private static List<String> deeds(GoalOutcome outcome) {
    return outcome.story().stream()
        .filter(
            entry ->
                entry.kind() == StoryEntry.Kind.STEP
                    || entry.kind() == StoryEntry.Kind.KNOWN && entry.text().startsWith("["))
        .map(entry -> entry.text().replaceFirst("^\\[[0-9.]+] ", ""))
        .filter(text -> !text.startsWith("Achieve"))
        .map(text -> text.replaceFirst("^Step \\d of \\d: ", ""))
        .toList();
  }

  /** Of Dave in the living room. */
  private static List<String> expected(String minute, String show) {
    return List.of(
        "Run (activateLights livingroom).",
        "lux measures the light in livingroom.",
        "lamp-1 is set to 1.",
        "lamp-2 is set to 0.5.",
        "lux measures the light in livingroom.",
        "Run (currenttime).",
        "?minute is " + minute + ".",
        "?currenttime is " + minute + ".",
        "Run (queryPrefs livingroom Dave \"TV show\" %s).".formatted(minute),
        "?choice is " + show + ".",
        "?show is " + show + ".",
        "Run (activateTV livingroom).",
        "television is switched on.",
        "Run (selectTVshow livingroom %s).".formatted(show),
        "television is tuned to %s.".formatted(show));
  }

  @Nested
  @MaestroTest(home = "livingroom", scene = "livingroom-evening")
  class InTheEvening {

    @Test
    void daveFindsTheOperaInALitRoom(Stage stage) {
      GoalOutcome outcome = stage.goal("(prepareRoom livingroom Dave)");

      assertThat(outcome).isReached();
      assertThat(deeds(outcome)).isEqualTo(expected("1215", "Opera"));
      assertThat(stage.world().lux("livingroom")).isGreaterThan(150);
      assertThat(stage.knowledge()).knows("(showing television Opera)");
    }

    @Test
    void eveFindsWhatSheLikesInTheBedroomByItsOwnDevices(Stage stage) {
      GoalOutcome outcome = stage.goal("(prepareRoom bedroom Eve)");

      assertThat(outcome).isReached();
      assertThat(deeds(outcome))
          .containsExactly(
              "Run (activateLights bedroom).",
              "bed-lux measures the light in bedroom.",
              "bed-lamp is set to 1.",
              "bed-lux measures the light in bedroom.",
              "Run (currenttime).",
              "?minute is 1215.",
              "?currenttime is 1215.",
              "Run (queryPrefs bedroom Eve \"TV show\" 1215).",
              "?choice is Cartoons.",
              "?show is Cartoons.",
              "Run (activateTV bedroom).",
              "bed-television is switched on.",
              "Run (selectTVshow bedroom Cartoons).",
              "bed-television is tuned to Cartoons.");
      assertThat(stage.world().lampLevel("lamp-1")).isZero();
      assertThat(stage.knowledge()).excludes("(switchedOn television)");
    }
  }

  /** What is known of persons, with who says so and since when (ADE, 4.1; A57). */
  @Nested
  @MaestroTest(home = "livingroom", scene = "livingroom-evening")
  class WhatIsKnownOfPersons {

    private static List<Answer> answers(Stage stage, String question) {
      return new Question(stage.knowledge().snapshot())
          .answerRef(
              new QuestionReader(stage.knowledge().home()).question(SlParser.formula(question)));
    }

    @Test
    void preferencesAndCuesAreAskedFor(Stage stage) {
      assertThat(answers(stage, "(exists (?p) (and (preferenceOf ?p Dave) (prefers ?p ?show)))"))
          .extracting(Answer::binding)
          .containsExactlyInAnyOrder(
              Map.of("show", new Term.Name("News")), Map.of("show", new Term.Name("Opera")));
      assertThat(answers(stage, "(and (looksLike ?who glasses) (soundsLike ?who deep-voice))"))
          .extracting(Answer::binding)
          .containsExactly(Map.of("who", new Term.Name("Dave")));
    }

    @Test
    void whatStandsInTheHomeIsToldWithItsFileAndSinceThePlatformBegan(Stage stage) {
      stage.run(Duration.ofSeconds(5));

      assertThat(answers(stage, "(prefers dave-evenings ?show)"))
          .singleElement()
          .satisfies(
              answer -> {
                assertThat(answer.because())
                    .extracting(Belief::fact, Belief::source)
                    .containsExactly(
                        tuple(
                            "(prefers dave-evenings Opera)",
                            new Source(Source.Kind.DESCRIBED, "livingroom.ttl")));
                assertThat(answer.age().orElseThrow())
                    .isGreaterThanOrEqualTo(Duration.ofSeconds(5));
              });
      assertThat(answers(stage, "(= (fromMinute dave-evenings) ?minute)"))
          .singleElement()
          .satisfies(
              answer ->
                  assertThat(answer.because())
                      .extracting(belief -> belief.source().agent())
                      .containsExactly("livingroom.ttl"));
    }

    /** The home calls it private, and stories are for all. */
    @Test
    void whatIsKnownOfAThingIsToldInStoriesWithoutWhatIsPrivate(Stage stage) {
      assertThat(stage.goal("(learnPrefs dave-evenings News)").story())
          .extracting(StoryEntry::text)
          .filteredOn(text -> text.startsWith("Known of dave-evenings"))
          .singleElement()
          .asString()
          .contains("Dave")
          .doesNotContain("Opera");
    }

    /** Of an answer that rests on both, who has said something since is told first. */
    @Test
    void whoSpokeSinceIsToldBeforeTheHome(Stage stage) {
      assertThat(stage.goal("(learnPrefs dave-evenings News)")).isReached();
      stage.run(Duration.ofSeconds(5));

      assertThat(
              answers(stage, "(and (preferenceOf dave-evenings Dave) (prefers dave-evenings ?s))"))
          .singleElement()
          .satisfies(
              answer -> {
                assertThat(answer.because())
                    .extracting(belief -> belief.source().agent())
                    .containsExactly("G1.1", "livingroom.ttl");
                assertThat(answer.age().orElseThrow()).isLessThan(Duration.ofSeconds(60));
              });
    }

    @Test
    void whatIsLearntLaterCountsAndSaysFromWhereItIs(Stage stage) {
      assertThat(stage.goal("(learnPrefs dave-evenings News)")).isReached();
      stage.run(Duration.ofSeconds(5));

      assertThat(answers(stage, "(prefers dave-evenings ?show)"))
          .singleElement()
          .satisfies(
              answer -> {
                assertThat(answer.binding()).containsEntry("show", new Term.Name("News"));
                assertThat(answer.age().orElseThrow()).isGreaterThan(Duration.ofSeconds(4));
                assertThat(answer.because())
                    .extracting(belief -> belief.source().agent())
                    .containsExactly("G1.1");
              });
      assertThat(stage.goal("(prepareRoom livingroom Dave)")).tells("television is tuned to News");
    }
  }

  /** Habits are counted from what happens (ADE, 4.1; A57). */
  @Nested
  @MaestroTest(home = "livingroom", scene = "livingroom-evening")
  class Habits {

    @Test
    void whatSomebodyWatchesIsCountedAndAskedFor(Stage stage) {
      stage
          .knowledge()
          .state(new Source(Source.Kind.OBSERVED, "user"), List.of("(in Dave livingroom)"));
      assertThat(stage.goal("(selectTVshow livingroom News)")).isReached();
      stage.run(Duration.ofSeconds(5));

      assertThat(
              new Question(stage.knowledge().snapshot())
                  .answerRef(
                      new QuestionReader(stage.knowledge().home())
                          .question(SlParser.formula("(= (watched Dave News) ?times)"))))
          .singleElement()
          .satisfies(
              answer -> {
                assertThat(answer.binding()).containsEntry("times", new Term.Number(1));
                assertThat(answer.age().orElseThrow()).isGreaterThan(Duration.ofSeconds(4));
                assertThat(answer.because())
                    .extracting(belief -> belief.source().agent())
                    .containsExactly("habits");
              });
      assertThat(stage.goal("(usualShow Dave)")).isReached().tells("?most is News");
    }
  }

  @Nested
  @MaestroTest(home = "livingroom", scene = "livingroom-morning")
  class InTheMorning {

    @Test
    void daveFindsTheNews(Stage stage) {
      GoalOutcome outcome = stage.goal("(prepareRoom livingroom Dave)");

      assertThat(outcome).isReached();
      assertThat(deeds(outcome)).isEqualTo(expected("450", "News"));
      assertThat(stage.knowledge()).knows("(showing television News)");
    }

    @Test
    void whoLikesNothingNowHasNoShowChosen(Stage stage) {
      GoalOutcome outcome = stage.goal("(prepareRoom livingroom Eve)");

      assertThat(outcome)
          .isNotReached()
          .isExplainedBy("There is no ?s - Show of which it is known");
      assertThat(stage.knowledge()).excludes("(switchedOn television)");
    }
  }
}
