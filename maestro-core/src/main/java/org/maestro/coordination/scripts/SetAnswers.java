package org.maestro.coordination.scripts;

import java.util.List;
import java.util.Optional;
import org.maestro.coordination.api.Speech;
import org.maestro.sl.AnswerFormat;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Numbers as they are set on a slider. */
record SetAnswers(AnswerFormat.Slider slider) implements Answers {

  @Override
  public Speech.Wanted wanted() {
    return new Speech.Wanted(Speech.Wanted.SLIDER, List.of(), Optional.of(slider));
  }

  @Override
  public Optional<Term> read(String answer) {
    return Answers.number(answer.strip()).filter(slider::takes).map(Term.Number::new);
  }

  @Override
  public String cure() {
    return "write a number from %s to %s, by steps of %s"
        .formatted(
            SlPrinter.print(slider.lowest()),
            SlPrinter.print(slider.highest()),
            SlPrinter.print(slider.step()));
  }
}
