package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

/**
 * Who speaks in a room whose agent listens is answered in the chat by whichever understands her.
 */
@Isolated("its time is wall time, which others beside it would take")
class RoomsOfConsoleTest {
  private static final String PASTA = "Heat up the pasta from last night.";
  private static final String READY = "The pasta will be ready in five minutes.";

  /** The dialogue of the ADE paper, section 5, with the delay that is added (A87). */
  @Test
  void whatTheBedroomDoesNotUnderstandTheKitchenDoesAndAnswersThere() throws Exception {
    try (ServedHome home = ServedHome.startRooms(UnaryOperator.identity())) {
      PersonInChat dave = new PersonInChat(home, "Dave", "bedroom");

      List<String> told = dave.says(PASTA, "The pasta is warm.");
      assertThat(told.get(0)).matches("Bedroom: I have asked Kitchen, which took [\\d.a-z]+ s\\.");
      assertThat(told)
          .containsSubsequence(
              "Kitchen: I will warm up the pasta.",
              "Kitchen: " + READY,
              "Kitchen: The pasta is warm.");
      assertThat(dave.says("why did you do that?", "You asked me")).hasSize(1);
      assertThat(dave.says("turn on the light", "is on."))
          .as("what the bedroom understands it does, without asking")
          .containsExactly(
              "Bedroom: I will turn on the bedroom light.", "Bedroom: The bedroom light is on.");
      dave.says("undo that", "Bedroom: The bedroom light is off.");
      dave.says("fold the blorp", "Bedroom: I do not know the word");
    }
  }

  /** The same dialogue with one voice for the whole home, by its file (A88). */
  @Test
  @Tag("full")
  void aHomeWithoutPersonasSpeaksWithOneVoice() throws Exception {
    try (ServedHome home =
        ServedHome.startRooms(text -> text.replaceAll("; maestro:persona \"[^\"]*\"", ""))) {
      assertThat(new PersonInChat(home, "Dave", "bedroom").says(PASTA, "The pasta is warm."))
          .startsWith("I will warm up the pasta.")
          .contains(READY, "The pasta is warm.")
          .noneMatch(line -> line.contains("Kitchen"));
    }
  }

  /** The agent of the house fails: the rooms carry on with what they have (A91). */
  @Test
  void withoutACentralAgentARoomCarriesOn() throws Exception {
    try (ServedHome home = ServedHome.startRooms(UnaryOperator.identity())) {
      home.site().platform().endAgent("CCA");
      PersonInChat dave = new PersonInChat(home, "Dave", "bedroom");

      assertThat(dave.says("turn on the light", "is on."))
          .contains(
              "Bedroom: The rest of the home cannot be asked now; I do it with what is in this"
                  + " room.",
              "Bedroom: The bedroom light is on.");
      dave.says("turn on the bathroom light", "Bedroom: I could not turn on the bathroom light.");
      dave.says("is the bedroom light on?", "Bedroom: Yes.");
    }
  }
}
