package org.maestro.ontology.home;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Predicate;
import org.maestro.ontology.validation.Nearest;
import org.maestro.sl.Body;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Checks what a script keeps for itself: components that there are, of those who have them. */
final class HoldCheck {
  private final Home home;
  private final Offers offers;
  private final BiConsumer<String, String> problems;

  HoldCheck(Home home, Offers offers, BiConsumer<String, String> problems) {
    this.home = home;
    this.offers = offers;
    this.problems = problems;
  }

  /**
   * @param variables those that can be used, with their classes and datatypes
   */
  void check(Body.Hold hold, Map<String, List<String>> variables) {
    String member = SlPrinter.print(hold.member());
    if (hold.member() instanceof Term.Name name && !home.individuals().containsKey(name.text())) {
      return; // It is told that it is not described.
    }
    Set<String> components = offers.components(whoever(hold.member(), variables));
    if (components.isEmpty()) {
      problems.accept(
          "holds %s of %s, which has no components".formatted(hold.component(), member),
          "name a device whose features occupy some");
    } else if (!components.contains(hold.component())) {
      problems.accept(
          "holds the unknown component %s of %s".formatted(hold.component(), member),
          Nearest.cure(hold.component(), components, "it has " + String.join(", ", components)));
    }
  }

  private Predicate<String> whoever(Term member, Map<String, List<String>> variables) {
    if (member instanceof Term.Variable variable) {
      List<String> classes = variables.getOrDefault(variable.name(), List.of());
      return classes.isEmpty() ? anybody -> true : offers.whoMayBe(classes);
    }
    return offerer -> new Term.Name(offerer).equals(member);
  }
}
