package org.maestro.language.meaning;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.maestro.language.grammar.Form;
import org.maestro.language.reference.NounPhrases;
import org.maestro.language.reference.Reference;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.home.Individual;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * What somebody says, as the answer to a question of a script: in the words in which scripts take
 * answers. Immutable.
 */
public final class SaidAnswer {
  private static final String YES = "yes";
  private static final String NO = "no";

  private final String type;
  private final Situation situation;

  /**
   * @param type of answer that is wanted: {@code boolean}, {@code duration}, or a class of the home
   * @param situation in which nothing was asked back
   */
  public SaidAnswer(String type, Situation situation) {
    this.type = type;
    this.situation = situation;
  }

  /**
   * The answer: yes or no, a number of seconds, or the name of a thing.
   *
   * @param meanings of all readings, the best first
   */
  public Optional<String> of(List<Meaning> meanings) {
    return meanings.stream().map(Meaning::form).flatMap(form -> answer(form).stream()).findFirst();
  }

  private Optional<String> answer(Form form) {
    return switch (type) {
      case "boolean" ->
          Optional.of(form.head()).filter(head -> head.equals(YES) || head.equals(NO));
      case "duration" -> form.is(NO) ? Optional.of("0") : span(form);
      default -> phrases(form).flatMap(phrase -> thing(phrase).stream()).findFirst();
    };
  }

  private static Optional<String> span(Form form) {
    boolean isAnswer = form.is(YES) || form.is("answer");
    Form said = form.part(0);
    return isAnswer && (said.is("span") || said.is("plus"))
        ? Optional.of(SlPrinter.print(Values.seconds(said)))
        : Optional.empty();
  }

  private static Stream<Form> phrases(Form form) {
    return form.is("np") ? Stream.of(form) : form.parts().stream().flatMap(SaidAnswer::phrases);
  }

  private Optional<String> thing(Form phrase) {
    return new NounPhrases(situation).resolve(phrase, type) instanceof Reference.Single single
            && single.term() instanceof Term.Name name
        ? Optional.ofNullable(situation.home().individuals().get(name.text()))
            .filter(one -> one.classes().contains(type))
            .map(Individual::name)
        : Optional.empty();
  }
}
