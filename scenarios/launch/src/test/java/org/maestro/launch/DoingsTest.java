package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.language.Language;
import org.maestro.language.Understanding;
import org.maestro.language.reference.Discourse;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Facts;
import org.maestro.sl.SlPrinter;

/** What is asked about what is being done, and what is called off or tried again, has a message. */
class DoingsTest {
  private static final Home HOME = Shipped.home("evening");
  private static final Language LANGUAGE = Language.of(HOME, "en");
  private static final Facts FACTS =
      SceneFacts.of(HOME, Optional.of(Shipped.scene("evening", HOME)));

  private static Understanding understood(String text) {
    return LANGUAGE.understand(
        text,
        new Situation(
            HOME,
            FACTS,
            Optional.of("Dave"),
            Optional.of("kitchen"),
            Optional.empty(),
            OptionalInt.empty(),
            Discourse.NONE));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "what are you doing?             | (query-ref (:doing))",
        "What are you up to now?         | (query-ref (:doing))",
        "what is going on in the bedroom | (query-ref (:doing))",
        "what did you do                 | (query-ref (:done))",
        "what are you going to do?       | (query-ref (:planned))",
        "what did I ask for?             | (query-ref (:asked))",
        "is it done?                     | (query-if (:done))",
        "are you finished                | (query-if (:done))",
        "how long will it take?          | (query-ref (:lasts))",
        "when will you be done?          | (query-ref (:lasts))",
        "how much longer                 | (query-ref (:lasts))",
        "why?                            | (explain)",
        "why did you do that             | (explain)",
        "what went wrong                 | (explain)",
        "why did you turn on the light?  | (explain (:goal (= (level kitchen-lamp) 1)))",
        "why is the kitchen light on     | (explain (:goal (= (level kitchen-lamp) 1)))",
        "why are you turning on the light | (explain (:goal (= (level kitchen-lamp) 1)))",
        "who turned on the light         | (query-ref (:history \"(= (level kitchen-lamp) 1)\"))",
        "who did that?                   | (query-ref (:history))",
        "what can you do                 | (query-ref (:able))",
        "what can you do here?           | (query-ref (:able kitchen))",
        "what can you do in the bedroom? | (query-ref (:able bedroom))",
        "never mind                      | (cancel (:question))",
        "forget it                       | (cancel (:question))",
        "stop                            | (cancel (:last))",
        "stop that                       | (cancel (:last))",
        "cancel it                       | (cancel (:last))",
        "don't                           | (cancel (:last))",
        "call it off                     | (cancel (:last))",
        "I changed my mind               | (cancel (:last))",
        "don't turn on the light         | (cancel (:goal (= (level kitchen-lamp) 1)))",
        "stop turning on the light       | (cancel (:goal (= (level kitchen-lamp) 1)))",
        "try again                       | (initCNP (:last))",
        "do it again                     | (initCNP (:last))",
        "once more                       | (initCNP (:last))"
      })
  void meansAMessage(String text, String message) {
    assertThat(understood(text).message().map(SlPrinter::print)).contains(message);
  }
}
