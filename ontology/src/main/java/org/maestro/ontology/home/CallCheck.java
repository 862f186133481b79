package org.maestro.ontology.home;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.ontology.validation.Nearest;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.sl.Body;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * Checks what a script has single members do: features that there are, of those who offer them, and
 * with what they take.
 */
final class CallCheck {
  private final Home home;
  private final Offers offers;
  private final TermFit fit;
  private final BiConsumer<String, String> problems;

  CallCheck(Home home, Offers offers, BiConsumer<String, String> problems) {
    this.home = home;
    this.offers = offers;
    this.fit = new TermFit(home);
    this.problems = problems;
  }

  /**
   * @param variables those that can be used, with their classes and datatypes
   */
  void check(Body.Do call, Map<String, List<String>> variables) {
    String feature = call.feature();
    if (!offers.known().contains(feature)) {
      problems.accept(
          "calls the unknown feature " + feature,
          Nearest.cure(
              feature, offers.known(), "name one of " + String.join(", ", offers.known())));
    } else if (offers.of(feature, anybody -> true).isEmpty()) {
      problems.accept(
          "calls %s, which no device offers".formatted(feature),
          "say which class of devices does (maestro:offers), or call another feature");
    } else {
      List<FeatureType> offered = offered(call, variables);
      call.parameters().forEach((name, term) -> check(call, name, term, offered, variables));
    }
  }

  /** The feature as the member, or whoever it may be, offers it; told when none does. */
  private List<FeatureType> offered(Body.Do call, Map<String, List<String>> variables) {
    String feature = call.feature();
    List<FeatureType> all = offers.of(feature, anybody -> true);
    List<FeatureType> own = all;
    if (call.member() instanceof Term.Variable variable) {
      List<String> classes = variables.getOrDefault(variable.name(), List.of());
      own = classes.isEmpty() ? all : offers.of(feature, offers.whoMayBe(classes));
    } else if (!(call.member() instanceof Term.Name name)) {
      tell(call, "is no device");
    } else if (home.devices().containsKey(name.text())) {
      own = offers.of(feature, name.text()::equals);
    } else if (home.individuals().containsKey(name.text())) {
      tell(call, "is no device");
    }
    if (own.isEmpty()) {
      tell(call, "does not offer it");
    }
    return own.isEmpty() ? all : own;
  }

  private void tell(Body.Do call, String problem) {
    Optional<String> example =
        home.devices().keySet().stream()
            .filter(name -> !offers.of(call.feature(), name::equals).isEmpty())
            .findFirst();
    problems.accept(
        "calls %s of %s, which %s"
            .formatted(call.feature(), SlPrinter.print(call.member()), problem),
        "name a device that offers it" + example.map(name -> ", such as " + name).orElse(""));
  }

  private void check(
      Body.Do call,
      String name,
      Term term,
      List<FeatureType> offered,
      Map<String, List<String>> variables) {
    List<Parameter> taken =
        offered.stream()
            .flatMap(CallCheck::parameters)
            .filter(parameter -> parameter.name().equals(name))
            .toList();
    if (taken.isEmpty()) {
      List<String> names =
          offered.stream()
              .flatMap(CallCheck::parameters)
              .map(parameter -> ":" + parameter.name())
              .distinct()
              .sorted()
              .toList();
      problems.accept(
          "gives %s the unknown parameter :%s".formatted(call.feature(), name),
          Nearest.cure(
              ":" + name,
              names,
              names.isEmpty() ? "it takes none" : "it takes " + String.join(", ", names)));
    } else if (taken.stream().noneMatch(parameter -> takes(parameter, term, variables))) {
      problems.accept(
          "gives %s for :%s of %s, which cannot be that"
              .formatted(SlPrinter.print(term), name, call.feature()),
          "give it " + wanted(taken.get(0)));
    }
  }

  private static Stream<Parameter> parameters(FeatureType feature) {
    return Stream.concat(feature.inputs().stream(), feature.binds().stream());
  }

  private boolean takes(Parameter parameter, Term term, Map<String, List<String>> variables) {
    return fit.fits(term, parameter.types(), variables)
        && (!term.isGround() || parameter.oneOf().isEmpty() || parameter.oneOf().contains(term));
  }

  private static String wanted(Parameter parameter) {
    return parameter.oneOf().isEmpty()
        ? "a " + String.join(" or ", parameter.types())
        : "one of "
            + parameter.oneOf().stream().map(SlPrinter::print).collect(Collectors.joining(", "));
  }
}
