package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.net.http.HttpResponse;
import java.time.Duration;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.StreamSupport;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.openqa.selenium.Keys;

/** A person of the home says what is to be so, and hears what becomes of it. */
@Isolated("its time is wall time, which others beside it would take")
class ChatPageTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static ServedHome home;

  @BeforeAll
  static void start() {
    home =
        ServedHome.startWithMore(
            """

            home:greet a maestro:Script ; maestro:arguments ( "?who - Person" "?room - Room" ) ;
              maestro:body \"""(seq (say ?who "Hello," ?who ".") (say ?room "It is dark.") (express "at ease" 0.8))\""" .
            home:offer a maestro:Script ; maestro:arguments ( "?whom - Listener" ) ;
              maestro:body \"""(seq (ask ?whom "How bright?" ?lux double)
                (ask ?whom "Shall it stay?" ?stay boolean) (return ?lux))\""" .
            home:rate a maestro:Script ; maestro:arguments ( "?whom - Listener" ) ;
              maestro:body \"""(seq (ask ?whom "How was it?" ?how (choice "good" "=fair" "bad"))
                (ask ?whom "How sure are you?" ?sure (slider 1 7 2 "not at all" "very")) (return ?sure))\""" .
            """);
  }

  @AfterAll
  static void end() {
    home.close();
  }

  private static ServedHome.Answer say(String person, String room, String text) throws Exception {
    return home.post(
        "/chat",
        new ObjectMapper()
            .createObjectNode()
            .put("person", person)
            .put("room", room)
            .put("text", text)
            .toString());
  }

  /** Waits for an entry of the kind that came after the number. */
  private static JsonNode answer(long after, String kind) {
    return Awaitility.await()
        .atMost(LIMIT)
        .until(() -> find(after, kind), found -> !found.isMissingNode());
  }

  /** The same, of a goal: those of other tests may still be under way. */
  private static JsonNode answer(long after, String kind, String goal) {
    return Awaitility.await()
        .atMost(LIMIT)
        .until(
            () -> find(after, kind, entry -> entry.path("goal").asText().equals(goal)),
            found -> !found.isMissingNode());
  }

  private static JsonNode find(long after, String kind) throws Exception {
    return find(after, kind, entry -> true);
  }

  private static JsonNode find(long after, String kind, Predicate<JsonNode> wanted)
      throws Exception {
    JsonNode entries = home.get("/chat").document().path("entries");
    return StreamSupport.stream(entries.spliterator(), false)
        .filter(entry -> entry.path("number").asLong() > after)
        .filter(entry -> entry.path("kind").asText().equals(kind))
        .filter(wanted)
        .findFirst()
        .orElse(entries.path("none"));
  }

  @Test
  void aGoalIsUnderstoodAtOnceAndFollowedToItsEnd() throws Exception {
    ServedHome.Answer accepted = say("Bob", "room-a", "illuminance here 40");
    assertThat(accepted.status()).isEqualTo(201);
    home.assertValid(accepted.document(), "chat-accepted");
    long number = accepted.document().path("number").asLong();

    JsonNode understood = answer(number, "understood");
    assertThat(understood.path("text").asText()).isEqualTo("(>= (illuminance zone-a) 40)");
    String goal = understood.path("goal").asText();
    JsonNode reached = answer(number, "reached", goal);
    assertThat(reached.path("text").asText()).startsWith("Reached");
    home.assertValid(home.get("/chat").document(), "chat");

    long impossible =
        say("Bob", "room-a", "(>= (illuminance zone-a) 100000)").document().path("number").asLong();
    assertThat(answer(impossible, "ended").path("text").asText()).startsWith("Not reached.");
  }

  @Test
  void whatIsSaidAsPeopleSpeakIsDoneAndAnswered() throws Exception {
    long wish =
        say("Bob", "room-a", "Could you turn on all the lamps in here, please?")
            .document()
            .path("number")
            .asLong();
    JsonNode understood = answer(wish, "understood");
    assertThat(understood.path("text").asText()).isEqualTo("I will turn on lamp A1 and lamp A2.");
    assertThat(answer(wish, "reached", understood.path("goal").asText()).path("text").asText())
        .isEqualTo("Lamp A1 and lamp A2 are on.");

    long question =
        say("Bob", "room-a", "How many lamps are on in here?").document().path("number").asLong();
    assertThat(answer(question, "told").path("text").asText()).isEqualTo("Two.");

    long open = say("Bob", "room-a", "Turn off the lamp.").document().path("number").asLong();
    assertThat(answer(open, "asked").path("text").asText()).startsWith("Which lamp");
    long chosen = say("Bob", "room-a", "lamp A1").document().path("number").asLong();
    assertThat(answer(chosen, "understood").path("text").asText())
        .isEqualTo("I will turn off lamp A1.");
  }

  @Test
  void whatLacksAPartIsAskedForAndTheNextWordsAreTheAnswer() throws Exception {
    long first = say("Bob", "room-a", "illuminance here").document().path("number").asLong();
    assertThat(answer(first, "asked").path("text").asText()).contains("at least how much?");
    long second = say("Bob", "room-b", "30").document().path("number").asLong();
    assertThat(answer(second, "understood").path("text").asText())
        .as("here is where it was begun")
        .isEqualTo("(>= (illuminance zone-a) 30)");

    long third = say("Bob", "room-a", "? in rose").document().path("number").asLong();
    assertThat(answer(third, "told").path("text").asText()).matches("Yes: p is zone-[ab].*");
  }

  @Test
  void whatAScriptSaysIsHeardByThePersonAndInTheRoom() throws Exception {
    String goal = home.state("(greet Bob room-b)");

    Awaitility.await().atMost(LIMIT).until(() -> spoken(goal).size() == 2);
    assertThat(spoken(goal))
        .extracting(entry -> entry.path("person").asText() + "/" + entry.path("room").asText())
        .containsExactly("Bob/null", "null/room-b");
    assertThat(spoken(goal))
        .extracting(entry -> entry.path("text").asText())
        .containsExactly("Hello, Bob.", "It is dark.");
    JsonNode shown =
        Awaitility.await()
            .atMost(LIMIT)
            .until(
                () -> find(0, "shown", entry -> entry.path("goal").asText().equals(goal)),
                found -> !found.isMissingNode());
    assertThat(shown.path("text").asText()).isEqualTo("CCA is at ease, by 0.8.");
    JsonNode moods = home.get("/moods").document();
    home.assertValid(moods, "moods");
    assertThat(moods.at("/moods/0/agent").asText()).isEqualTo("CCA");
    assertThat(moods.at("/moods/0/word").asText()).isEqualTo("at ease");
    assertThat(moods.at("/moods/0/intensity").asDouble()).isEqualTo(0.8);
    home.assertValid(home.get("/chat").document(), "chat");
    assertThat(home.get("/goals/" + goal + "/story").document().toString())
        .contains("\"kind\":\"said\"")
        .contains("To Bob: \\\"Hello, Bob.\\\"");
  }

  @Test
  void aQuestionOfAScriptIsAnsweredByTheNextWordsThatWouldDo() throws Exception {
    String goal = home.state("(offer Bob)");
    JsonNode asked = asked(goal, "How bright?");
    assertThat(asked.path("person").asText()).isEqualTo("Bob");
    assertThat(asked.path("question").asText()).isEqualTo(goal + ".1");

    long wrong = say("Bob", "room-a", "very").document().path("number").asLong();
    assertThat(answer(wrong, "misunderstood").path("text").asText())
        .isEqualTo(goal + ".1 is not answered by \"very\"; write a number, such as 21.5.");
    long right = say("Bob", "room-a", "40").document().path("number").asLong();
    assertThat(answer(right, "told", goal).path("text").asText())
        .isEqualTo("That is the answer to: How bright?");

    JsonNode next = asked(goal, "Shall it stay?");
    assertThat(next.path("near").toString()).isEqualTo("[\"yes\",\"no\"]");
    long meanwhile =
        say("Bob", "room-a", "(illuminance zone-a)").document().path("number").asLong();
    assertThat(find(meanwhile, "told", entry -> entry.path("goal").asText().equals(goal)))
        .as("a goal or question is no answer")
        .isEqualTo(home.get("/chat").document().path("none"));
    say("Bob", "room-a", "yes");
    Awaitility.await().atMost(LIMIT).until(() -> isOver(goal));
    home.assertValid(home.get("/chat").document(), "chat");
  }

  @Test
  void whatIsChosenOrSetIsKeptAndToBeHadAsAFile() throws Exception {
    String goal = home.state("(rate Bob)");
    JsonNode choice = asked(goal, "How was it?");
    assertThat(choice.path("choice").toString()).isEqualTo("[\"good\",\"=fair\",\"bad\"]");
    assertThat(choice.path("slider").isNull()).isTrue();
    assertThat(answered(goal + ".1", "=fair", "Alice").problem())
        .isEqualTo("This home has no person Alice; it has Bob.");
    assertThat(answered(goal + ".1", "4", "Bob").problem())
        .isEqualTo(goal + ".1 is not answered by \"4\"; write one of good, =fair, bad.");
    assertThat(answered(goal + ".1", "=fair", "Bob").status()).isEqualTo(204);
    JsonNode slider = asked(goal, "How sure are you?").path("slider");
    assertThat(slider.path("step").asInt()).isEqualTo(2);
    assertThat(slider.path("highest_label").asText()).isEqualTo("very");
    assertThat(answered(goal + ".1.1.1", "4", "Bob").problem()).contains("by steps of 2.");
    assertThat(answered(goal + ".1.1.1", "5", "Bob").status()).isEqualTo(204);
    home.assertValid(home.get("/chat").document(), "chat");

    JsonNode answers = home.get("/answers?script=rate").document();
    home.assertValid(answers, "answers");
    assertThat(ofGoal(answers, goal)).containsExactly("=fair", "5");
    assertThat(home.get("/answers?script=greet").document().path("answers")).isEmpty();
    HttpResponse<String> csv = home.whole("/api/v1/answers.csv?script=rate");
    assertThat(csv.headers().firstValue("Content-Type")).contains("text/csv");
    assertThat(csv.body()).contains("\"Bob\",\"How was it?\",\"'=fair\",\"rate\",\"(rate Bob)\"");
  }

  private static ServedHome.Answer answered(String question, String text, String person)
      throws Exception {
    return home.post(
        "/questions/" + question + "/answer",
        new ObjectMapper().createObjectNode().put("text", text).put("person", person).toString());
  }

  private static List<String> ofGoal(JsonNode answers, String goal) {
    return StreamSupport.stream(answers.path("answers").spliterator(), false)
        .filter(answer -> answer.path("part").asText().startsWith(goal + "."))
        .map(answer -> answer.path("answer").asText())
        .toList();
  }

  /** Whoever is in the room may answer, and who cancels the script is asked nothing any more. */
  @Test
  void aQuestionInARoomIsAnsweredByTheOperationToo() throws Exception {
    String goal = home.state("(offer room-b)");
    asked(goal, "How bright?");

    ServedHome.Answer refused = home.post("/questions/" + goal + ".1/answer", "{\"text\":\"no\"}");
    assertThat(refused.status()).isEqualTo(400);
    assertThat(refused.problem()).contains("write a number");
    assertThat(home.post("/questions/" + goal + ".1/answer", "{\"text\":\"7\"}").status())
        .isEqualTo(204);
    ServedHome.Answer again = home.post("/questions/" + goal + ".1/answer", "{\"text\":\"7\"}");
    assertThat(again.status()).isEqualTo(404);
    assertThat(again.problem())
        .isEqualTo(
            "There is no open question %s.1; ./maestro goals shows who waits for an answer."
                .formatted(goal));
    asked(goal, "Shall it stay?");
    assertThat(home.get("/goals").document().toString())
        .contains("for an answer of room-b to \\\"Shall it stay?\\\"");
    home.delete("/goals/" + goal);
    Awaitility.await().atMost(LIMIT).until(() -> isOver(goal));

    long number = say("Bob", "room-b", "illuminance here 20").document().path("number").asLong();
    assertThat(answer(number, "understood").path("text").asText())
        .isEqualTo("(>= (illuminance zone-b) 20)");
  }

  private static boolean isOver(String goal) throws Exception {
    return home.get("/goals/" + goal + "/story").document().toString().contains("\"kind\":\"end\"");
  }

  private static JsonNode asked(String goal, String text) {
    return Awaitility.await()
        .atMost(LIMIT)
        .until(
            () ->
                find(
                    0,
                    "asked",
                    entry ->
                        entry.path("goal").asText().equals(goal)
                            && entry.path("text").asText().equals(text)),
            found -> !found.isMissingNode());
  }

  private static List<JsonNode> spoken(String goal) throws Exception {
    return StreamSupport.stream(home.get("/chat").document().path("entries").spliterator(), false)
        .filter(entry -> entry.path("kind").asText().equals("spoken"))
        .filter(entry -> entry.path("goal").asText().equals(goal))
        .toList();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "Bobb | room-a | This home has no person Bobb; write Bob, if that is meant.",
        "Cup | room-a | This home has no person Cup; it has Bob.",
        "Bob | attic  | This home has no room attic; it has room-a, room-b."
      })
  void whoOrWhereNobodyIsIsASentence(String person, String room, String sentence) throws Exception {
    ServedHome.Answer answer = say(person, room, "the cup next to me");

    assertThat(answer.status()).isEqualTo(400);
    assertThat(answer.problem()).isEqualTo(sentence);
  }

  @Test
  void whatIsTooLongIsRefused() throws Exception {
    ServedHome.Answer answer = say("Bob", "room-a", "x".repeat(3_000));

    assertThat(answer.status()).isEqualTo(400);
    assertThat(answer.problem()).contains("longer than 2000 characters");
  }

  @Test
  void onThePageAChoiceIsRadioButtonsAndANumberASlider() throws Exception {
    assumeTrue(
        Browser.isThere(),
        "The page is not tried: there is no chromium with its chromedriver; .ci/install installs them.");
    try (Browser browser = Browser.open()) {
      browser.size(1440, 900);
      browser.complaints();
      browser.go(home.uri() + "/#view=chat&room=room-a");
      browser.waitForText("#chat-person", "Bob");
      String goal = home.state("(rate room-a)");

      browser.waitForText("#chat-question legend", "How was it?");
      Accessibility.assertForEverybody(browser, "#chat-question .options", "=fair");
      browser.waitFor("#chat-answer-0").sendKeys(Keys.SPACE, Keys.ARROW_DOWN, Keys.ARROW_DOWN);
      browser.click("#chat-question button");

      browser.waitForText("#chat-question legend", "How sure are you?");
      Accessibility.assertForEverybody(browser, "#chat-question .ends", "7: very");
      browser.waitFor("#chat-answer").sendKeys(Keys.END, Keys.ARROW_LEFT);
      browser.waitForText("#chat-question output", "5");
      browser.waitFor("#chat-answer").sendKeys(Keys.ENTER);
      browser.waitFor("#chat-question[hidden]");
      assertThat(ofGoal(home.get("/answers").document(), goal)).containsExactly("bad", "5");
      assertThat(browser.complaints()).isEmpty();
    }
  }

  @Test
  void onThePageItIsTypedAndFollowedAndOthersAreTypedMeanwhile() throws Exception {
    assumeTrue(
        Browser.isThere(),
        "The page is not tried: there is no chromium with its chromedriver; .ci/install installs them.");
    try (Browser browser = Browser.open()) {
      browser.size(1440, 900);
      browser.complaints();
      browser.go(home.uri() + "/#view=chat&room=room-b");
      browser.waitForText("#chat-person", "Bob");

      browser.waitFor("#chat-text").sendKeys("the cup next to me", Keys.ENTER);
      browser.waitForText("#chat-log .answer.understood", "(nextTo Cup Bob)");
      assertThat(browser.text("#chat-log .said-by-person")).contains("Bob, in room-b");
      browser.waitFor("#chat-text").sendKeys("polish the cup", Keys.ENTER);
      browser.waitForText("#chat-log .misunderstood", "I do not know the word \"polish\"");
      browser.waitFor("#chat-text").sendKeys("nextTo Cup", Keys.ENTER);
      browser.waitForText("#chat-log .asked", "which thing? Say its name.");
      browser.waitForText("#chat-log .told", "Plan 1");
      browser.waitForText("#chat-log .reached", "Reached");

      browser.run(
          "[...document.querySelectorAll('#chat-log .understood .row')].at(-1)"
              + ".dispatchEvent(new MouseEvent('click', {bubbles: true}))");
      browser.waitForText("#detail h2", "(nextTo Cup Bob)");
      assertThat(browser.address()).contains("view=chat").contains("room=room-b");
      browser.click("#chat-log .offer");
      assertThat(browser.waitFor("#chat-text").getDomProperty("value")).isNotEmpty();
      assertThat(browser.complaints()).isEmpty();
      Accessibility.assertForEverybody(browser, "#chat-log", "Understood");
    }
  }
}
