package org.maestro.ontology.home;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.sl.Term;

/** Whether a term can stand where something of a class or datatype is wanted. */
final class TermFit {
  private static final Set<String> TEXTS =
      Set.of(
          "Pose", Parameter.NEXT_PLACE, "string", "duration", "dateTime", "date", "time", "anyURI");

  private final Home home;

  TermFit(Home home) {
    this.home = home;
  }

  /**
   * Whether one of the types fits. Of what nobody knows everything fits: that it is unknown is told
   * by others.
   *
   * @param types classes and datatypes; none: all terms fit
   * @param variables the classes and datatypes of each, none where that is not known
   */
  boolean fits(Term term, Collection<String> types, Map<String, List<String>> variables) {
    return types.isEmpty() || types.stream().anyMatch(type -> fits(term, type, variables));
  }

  private boolean fits(Term term, String type, Map<String, List<String>> variables) {
    if (!isKnown(type)) {
      return true;
    }
    if (term instanceof Term.Variable variable) {
      List<String> given = variables.getOrDefault(variable.name(), List.of());
      return given.isEmpty() || given.stream().anyMatch(one -> mayBe(one, type));
    }
    if (term instanceof Term.Name name) {
      Individual thing = home.individuals().get(name.text());
      return thing == null || thing.classes().contains(type);
    }
    return valueOf(type).filter(kind -> kind.isInstance(term)).isPresent();
  }

  private boolean isKnown(String type) {
    return Parameter.isDatatype(type) || home.vocabulary().classes().containsKey(type);
  }

  private boolean mayBe(String given, String type) {
    if (!isKnown(given)) {
      return true;
    }
    return Parameter.isDatatype(given) || Parameter.isDatatype(type)
        ? valueOf(given).equals(valueOf(type))
        : home.vocabulary().mayBeBoth(given, type) || areBoth(given, type);
  }

  /** Whether something of the home is of both classes, as a room may be a zone. */
  private boolean areBoth(String one, String other) {
    return home.individuals().values().stream()
        .anyMatch(thing -> thing.classes().contains(one) && thing.classes().contains(other));
  }

  /** What is written for a value of the datatype; empty for a class. */
  private static Optional<Class<? extends Term>> valueOf(String type) {
    if (!Parameter.isDatatype(type)) {
      return Optional.empty();
    } else if (type.equals("boolean")) {
      return Optional.of(Term.Truth.class);
    }
    return Optional.of(TEXTS.contains(type) ? Term.Text.class : Term.Number.class);
  }
}
