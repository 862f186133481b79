package org.maestro.coordination.scripts;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.maestro.coordination.api.Speech;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Term;

/**
 * Answers of which one is chosen: by its words, or by its place among them, counted from 1.
 *
 * @param options in the order in which they are shown
 */
record ChosenAnswers(List<Term> options, Home home) implements Answers {

  @Override
  public Speech.Wanted wanted() {
    return new Speech.Wanted(Speech.Wanted.CHOICE, labels());
  }

  private List<String> labels() {
    return options.stream().map(option -> Sentence.of(List.of(option), home)).toList();
  }

  @Override
  public Optional<Term> read(String answer) {
    String text = answer.strip();
    List<String> labels = labels();
    return IntStream.range(0, options.size())
        .filter(at -> labels.get(at).equalsIgnoreCase(text) || isName(options.get(at), text))
        .boxed()
        .findFirst()
        .or(() -> Answers.number(text).flatMap(this::place))
        .map(options::get);
  }

  private static boolean isName(Term option, String text) {
    return option instanceof Term.Name name && name.text().equals(text);
  }

  /** Where numbers are to be chosen from, a number is never a place. */
  private Optional<Integer> place(double number) {
    boolean isPlace = number == Math.rint(number) && number >= 1 && number <= options.size();
    return isPlace && options.stream().noneMatch(Term.Number.class::isInstance)
        ? Optional.of((int) number - 1)
        : Optional.empty();
  }

  @Override
  public String cure() {
    return "write one of " + String.join(", ", labels());
  }
}
