package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

/**
 * Who speaks of goals in the chat is answered in words: how they fare, why, and what is not done.
 */
@Isolated("its time is wall time, which others beside it would take")
class TalkOfGoalsTest {
  /** Says it, and waits until that is told. */
  private static List<String> says(ServedHome home, String text, String awaited) throws Exception {
    return says(home, text, "en", awaited);
  }

  private static List<String> says(ServedHome home, String text, String language, String awaited)
      throws Exception {
    return new PersonInChat(home, "Bob", "room-a").says(text, language, awaited);
  }

  @Test
  void howAGoalFaresAndWhyIsToldInWords() throws Exception {
    try (ServedHome home = ServedHome.start()) {
      says(home, "what are you doing?", "Nothing just now.");
      says(home, "never mind", "There is nothing to call off.");
      says(home, "try again", "There is nothing to try again.");

      List<String> lit = says(home, "turn on lamp A1", "Lamp A1 is on.");
      assertThat(lit).contains("I will turn on lamp A1.");
      assertThat(String.join(" ", lit)).doesNotContain("lamp-a1", "G1");
      says(home, "is it done?", "Yes, it is done.");
      says(home, "why did you do that?", "You asked me to turn on lamp A1, ");
      says(home, "why is lamp A1 on?", "You asked me to turn on lamp A1, ");
      says(home, "who turned on lamp A1?", "You did, ");
      says(home, "what can you do here?", "I can turn on, turn off");
      says(home, "why is lamp B1 on?", "as far as I know");
    }
  }

  @Test
  void whatIsNotWishedAnyMoreIsCalledOff() throws Exception {
    try (ServedHome home = ServedHome.start()) {
      says(home, "in two hours turn on lamp A1", "I will turn on lamp A1 after two hours.");
      says(home, "what are you going to do?", "I will turn on lamp A1 after two hours.");
      says(home, "never mind", "I am no longer turning on lamp A1 after two hours.");

      says(home, "in two hours turn on lamp A1", "I will turn on lamp A1");
      says(home, "in three hours turn on lamp A2", "I will turn on lamp A2");
      says(home, "don't turn on lamp A1", "I am no longer turning on lamp A1");
      says(home, "in two hours turn on lamp A1", "I will turn on lamp A1");
      says(home, "in four hours turn on lamp B1", "I will turn on lamp B1");
      says(home, "stop", "I am no longer turning on lamp B1");
      says(home, "stop", "Which do you mean, turning on lamp A2");
      says(home, "never mind", "All right.");
      says(home, "stop", "Which do you mean, turning on lamp A2");
      says(home, "lamp A1", "I am no longer turning on lamp A1");
      says(home, "stop", "Do you mean turning on lamp A2");
      says(home, "yes", "I am no longer turning on lamp A2");
    }
  }

  @Test
  void whatNobodyKnowsIsLookedForWhenWished() throws Exception {
    try (ServedHome home = ServedHome.start()) {
      says(home, "where is the cup?", "I do not know. Shall I have a look?");
      says(home, "no", "All right.");
      says(home, "where is the cup?", "I do not know. Shall I have a look?");
      says(home, "yes", "The cup is in room ");
      says(home, "where is the cup?", "Room ");
    }
  }

  @Test
  void whatDidNotWorkIsToldWithTheReasonAndTriedAgain() throws Exception {
    try (ServedHome home = ServedHome.start()) {
      List<String> failed = says(home, "light up room A", "I could not light up room A. ");
      assertThat(failed).last().asString().doesNotContain("zone-a");
      says(home, "why?", "I could not");
      says(home, "try again", "I could not");
    }
  }

  @Test
  void whatIsSaidInAnotherLanguageIsAnsweredInIt() throws Exception {
    try (ServedHome home = ServedHome.start()) {
      assertThat(says(home, "mach Lampe A1 an", "de", "Lampe A1 ist an."))
          .contains("Ich werde Lampe A1 anmachen.");
      says(home, "ist es fertig?", "de", "Ja, das ist getan.");
      says(home, "warum ist Lampe A1 an?", "de", "Du batest mich: Lampe A1 anmachen; ");
      says(home, "why?", "You asked me to turn on lamp A1, ");
      says(home, "wo ist die Tasse?", "de", "Das weiß ich nicht. Soll ich nachsehen?");
      says(home, "nein", "de", "In Ordnung.");
      says(home, "in zwei Stunden mach Lampe A2 an", "de", "Ich werde Lampe A2 anmachen in");
      says(home, "stopp", "de", "Ich bin nicht mehr dabei: Lampe A2 anmachen in zwei Stunden.");
      says(home, "was kannst du hier?", "de", "Ich kann ");
    }
  }
}
