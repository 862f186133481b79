package org.maestro.coordination.scripts;

import java.util.List;
import java.util.Optional;
import org.maestro.coordination.api.Respondent;
import org.maestro.ontology.home.Home;
import org.maestro.sl.AnswerFormat;
import org.maestro.sl.Term;

/**
 * A question of a script to people.
 *
 * @param type see {@link org.maestro.sl.Body.Ask}
 * @param format of the answer, where it is chosen instead of written
 */
record Question(
    String who, List<Term> words, String type, Optional<AnswerFormat> format, Answered answered) {

  /** The answers that would do. */
  Answers answers(Home home) {
    if (format.isEmpty()) {
      return new WrittenAnswers(type, home);
    }
    return format.get() instanceof AnswerFormat.Choice choice
        ? new ChosenAnswers(choice.options(), home)
        : new SetAnswers((AnswerFormat.Slider) format.get());
  }

  /** Told once of the first answer that would do. */
  interface Answered {
    /**
     * @param answer what it stands for
     * @param taken to be run when it is taken
     */
    void with(Term answer, Respondent by, Runnable taken);
  }
}
