package org.maestro.coordination.scripts;

import java.util.Optional;
import org.maestro.coordination.api.Speech;
import org.maestro.ontology.home.Home;
import org.maestro.sl.AnswerFormat;
import org.maestro.sl.Term;

/** The answers to a question that would do, as people write them. */
interface Answers {

  static Answers to(Question question, Home home) {
    if (question.format().isEmpty()) {
      return new WrittenAnswers(question.type(), home);
    }
    return question.format().get() instanceof AnswerFormat.Choice choice
        ? new ChosenAnswers(choice.options(), home)
        : new SetAnswers((AnswerFormat.Slider) question.format().get());
  }

  /** What who is asked is told of them. */
  Speech.Wanted wanted();

  /** What the answer stands for; empty when it would not do. */
  Optional<Term> read(String answer);

  /** What to write instead. */
  String cure();

  /** The number that is written there, if it is one. */
  static Optional<Double> number(String text) {
    return text.matches("[-+]?[0-9]{1,15}([.][0-9]{1,15})?")
        ? Optional.of(Double.parseDouble(text))
        : Optional.empty();
  }
}
