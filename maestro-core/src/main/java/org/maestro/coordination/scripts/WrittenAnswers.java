package org.maestro.coordination.scripts;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.maestro.coordination.api.Speech;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sl.Term;

/**
 * Answers of one class or datatype.
 *
 * @param type see {@link org.maestro.sl.Body.Ask}
 */
record WrittenAnswers(String type, Home home) implements Answers {
  private static final int MOST_CHOICES = 12;
  private static final Map<String, Boolean> TRUTHS =
      Map.of("yes", true, "true", true, "no", false, "false", false);

  @Override
  public Speech.Wanted wanted() {
    return new Speech.Wanted(type, choices());
  }

  /** Some that would do; none where nobody could list them. */
  private List<String> choices() {
    return type.equals("boolean")
        ? List.of("yes", "no")
        : things().map(Individual::name).limit(MOST_CHOICES).toList();
  }

  @Override
  public Optional<Term> read(String answer) {
    String text = answer.strip();
    return switch (type) {
      case "string" -> Optional.of(text).filter(some -> !some.isEmpty()).map(Term.Text::new);
      case "boolean" ->
          Optional.ofNullable(TRUTHS.get(text.toLowerCase(Locale.ROOT))).map(Term.Truth::new);
      case "double", "decimal" -> Answers.number(text).map(Term.Number::new);
      case "duration" -> seconds(text);
      case "integer" -> Answers.number(text).filter(n -> n == Math.rint(n)).map(Term.Number::new);
      default -> thing(text);
    };
  }

  /** As people say it, it was read before, where their language is known. */
  private static Optional<Term> seconds(String text) {
    return Answers.number(text.replaceFirst("\\s*s(econds?)?$", ""))
        .filter(number -> number >= 0)
        .map(Term.Number::new);
  }

  /** By its name, or by its label as people write it. */
  private Optional<Term> thing(String text) {
    return things()
        .filter(one -> one.name().equals(text))
        .findFirst()
        .or(() -> things().filter(one -> one.label().equalsIgnoreCase(text)).findFirst())
        .map(one -> new Term.Name(one.name()));
  }

  private Stream<Individual> things() {
    return home.individuals().values().stream().filter(one -> one.classes().contains(type));
  }

  @Override
  public String cure() {
    return switch (type) {
      case "string" -> "write some words";
      case "double", "decimal" -> "write a number, such as 21.5";
      case "integer" -> "write a whole number, such as 3";
      case "duration" -> "say how long, such as half an hour, or 0 seconds";
      default -> {
        List<String> choices = choices();
        yield choices.isEmpty()
            ? "the home has no " + type
            : "write " + (choices.size() == 1 ? "" : "one of ") + String.join(", ", choices);
      }
    };
  }
}
