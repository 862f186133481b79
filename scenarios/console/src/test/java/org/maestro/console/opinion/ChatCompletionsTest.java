package org.maestro.console.opinion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.URI;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.maestro.dialogue.Sayable;

/** What is asked of a language model, and what is made of what it answers. */
class ChatCompletionsTest {
  private static final Duration LONG = Duration.ofSeconds(30);
  private static final Sayable KNOWN =
      new Sayable(List.of("turn on {object}"), List.of("lamp A1", "room A"));

  private static List<String> proposals(URI base, Duration patience) throws Exception {
    return new ChatCompletions(base, Optional.of("small"), Optional.of("s3cret"), patience)
        .proposals("gimme light", KNOWN)
        .get(LONG.toSeconds(), TimeUnit.SECONDS);
  }

  private static List<String> proposals(Model model) throws Exception {
    return proposals(model.base(), LONG);
  }

  @Test
  void whatItSaysIsProposed() throws Exception {
    try (Model model = Model.saying("turn on lamp A1")) {
      assertThat(proposals(model)).containsExactly("turn on lamp A1");
      assertThat(model.asked())
          .singleElement()
          .asString()
          .startsWith("Bearer s3cret\n")
          .contains("gimme light", "turn on {object}", "lamp A1, room A", "\"model\":\"small\"");
      assertThat(model.asked().get(0).split("\n", 2)[1]).doesNotContain("s3cret");
    }
  }

  @Test
  void ofWhatItSaysTooMuchTheFirstCounts() throws Exception {
    try (Model model =
        Model.saying(
            "- \"turn on lamp A1\"\n\n2. turn off lamp A1\n" + "x".repeat(500) + "\na\nb")) {
      assertThat(proposals(model)).containsExactly("turn on lamp A1", "turn off lamp A1", "a");
    }
  }

  @Test
  void nothingIsProposedByAnAnswerOfAnotherKind() throws Exception {
    for (String body : List.of("{}", "[]", "null", "{\"choices\":[]}", "{\"choices\":7}")) {
      try (Model model = Model.sending(200, body)) {
        assertThat(proposals(model)).isEmpty();
      }
    }
  }

  @Test
  void whyItIsNoneIsTold() {
    try (Model model = Model.sending(200, "<html>")) {
      assertThatThrownBy(() -> proposals(model)).hasMessageContaining("its answer is no JSON");
    }
    try (Model model = Model.sending(401, "{}")) {
      assertThatThrownBy(() -> proposals(model))
          .hasMessageContaining("it answers with status 401")
          .hasMessageNotContaining("s3cret");
    }
  }

  @Test
  void whoNeverAnswersOrNeverEndsIsNotWaitedFor() throws Exception {
    try (Model model = Model.silent()) {
      assertThatThrownBy(() -> proposals(model.base(), Duration.ofMillis(300)))
          .isInstanceOf(ExecutionException.class);
    }
    try (Model model = Model.stalling()) {
      assertThatThrownBy(() -> proposals(model.base(), Duration.ofMillis(300)))
          .isInstanceOf(ExecutionException.class);
    }
    try (Model model = Model.endless()) {
      assertThat(proposals(model)).isEmpty();
    }
    assertThatThrownBy(() -> proposals(URI.create("http://127.0.0.1:1/v1/"), LONG))
        .isInstanceOf(ExecutionException.class);
  }
}
