package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import org.maestro.ontology.validation.Nearest;
import org.maestro.sl.Body;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * Checks what a script says to whom, and has looked at: persons and rooms hear, things are seen,
 * and each variable of a message that looks like one of the script's is one.
 */
final class SpeechCheck {
  private static final List<String> WHO_HEARS = List.of("Listener");

  /** Which is a number of seconds in the script. */
  private static final String DURATION = "duration";

  /** What people can write that is no name of a thing. */
  private static final List<String> ANSWERS =
      List.of("string", "boolean", "double", "decimal", "integer", DURATION);

  private static final List<String> A_NUMBER = List.of("decimal");

  private final Home home;
  private final TermFit fit;
  private final AnswerFormatCheck formats;
  private final BiConsumer<String, String> problems;

  SpeechCheck(Home home, BiConsumer<String, String> problems) {
    this.home = home;
    this.fit = new TermFit(home);
    this.formats = new AnswerFormatCheck(problems);
    this.problems = problems;
  }

  /**
   * @param variables those that can be used, with their classes and datatypes
   */
  void hears(Term who, Map<String, List<String>> variables) {
    if (!fit.fits(who, WHO_HEARS, variables)) {
      problems.accept(
          "speaks to %s, which is neither a person nor a room".formatted(SlPrinter.print(who)),
          "name one that is a maestro:Listener" + example());
    }
  }

  /** The class or datatype of what the script is answered. */
  static String answer(Body.Ask ask) {
    return ask.type().equals(DURATION) ? "decimal" : ask.type();
  }

  void check(Body.Ask ask, Map<String, List<String>> variables) {
    hears(ask.who(), variables);
    ask.format().ifPresent(formats::check);
    String type = ask.type();
    Set<String> classes = home.vocabulary().classes().keySet();
    if (!ANSWERS.contains(type) && !classes.contains(type)) {
      List<String> known = new ArrayList<>(ANSWERS);
      known.addAll(classes);
      problems.accept(
          "asks for an answer of the unknown class " + type,
          Nearest.cure(type, known, "write a class, or one of " + String.join(", ", ANSWERS)));
    }
  }

  /** Any word will do for a mood. */
  void check(Body.Express express, Map<String, List<String>> variables) {
    Term intensity = express.intensity();
    boolean isShare =
        !(intensity instanceof Term.Number number) || number.value() >= 0 && number.value() <= 1;
    if (!isShare || !fit.fits(intensity, A_NUMBER, variables)) {
      problems.accept(
          "expresses something by %s, which is no number from 0 to 1"
              .formatted(SlPrinter.print(intensity)),
          "write how much, such as (express glad 0.8)");
    }
    boolean isWord =
        express.word() instanceof Term.Name
            || express.word() instanceof Term.Text
            || express.word() instanceof Term.Variable;
    if (!isWord) {
      problems.accept(
          "expresses %s, which is no word".formatted(SlPrinter.print(express.word())),
          "write a word, such as (express glad 0.8)");
    }
  }

  /** What is to be looked at is a thing of which there is something to see. */
  void check(Body.Look look, Map<String, List<String>> variables) {
    Sights sights = new Sights(home.vocabulary());
    boolean isSeen =
        look.thing() instanceof Term.Variable variable
            ? variables.getOrDefault(variable.name(), List.of("Thing")).stream()
                .anyMatch(sights::mayBeOf)
            : look.thing() instanceof Term.Name name
                && Optional.ofNullable(home.individuals().get(name.text()))
                    .map(sights::areOf)
                    .orElse(true);
    if (!isSeen) {
      problems.accept(
          "looks at %s, of which there is nothing to see".formatted(SlPrinter.print(look.thing())),
          "name a thing that can be somewhere, or of which something maestro:Observable may be so");
    }
  }

  private String example() {
    return home.individuals().values().stream()
        .filter(one -> one.classes().containsAll(WHO_HEARS))
        .findFirst()
        .map(one -> ", such as " + one.name())
        .orElse("");
  }

  /** Agents come and go, and what they take is their matter: that is told when it is sent. */
  void check(Body.Tell tell, Map<String, List<String>> variables) {
    if (!(tell.agent() instanceof Term.Name || tell.agent() instanceof Term.Text)
        && !(tell.agent() instanceof Term.Variable)) {
      problems.accept(
          "tells %s something, which is no agent".formatted(SlPrinter.print(tell.agent())),
          "write the name of an agent, such as CCA");
    }
    FreeVariables.of(tell.message()).stream()
        .filter(name -> !variables.containsKey(name))
        .forEach(name -> slip(name, variables));
  }

  /** What nothing binds is open in the message, as in any; but not where it is nearly a name. */
  private void slip(String name, Map<String, List<String>> variables) {
    Nearest.to(name, variables.keySet())
        .ifPresent(
            other ->
                problems.accept(
                    "uses ?%s in a message, which nothing binds".formatted(name),
                    "write ?%s, if that is meant, or else another name".formatted(other)));
  }
}
