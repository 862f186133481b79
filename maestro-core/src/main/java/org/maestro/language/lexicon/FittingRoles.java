package org.maestro.language.lexicon;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.maestro.language.grammar.Form;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.wording.Construction;

/**
 * Whether what fills a construction's roles may be of their classes, as far as words alone tell.
 * Immutable.
 */
public final class FittingRoles implements Predicate<Form> {
  private final Home home;
  private final Map<String, Construction> constructions = new HashMap<>();

  public FittingRoles(Home home) {
    this.home = home;
    home.wording().constructions().forEach(one -> constructions.put(one.name(), one));
  }

  @Override
  public boolean test(Form form) {
    Construction construction = form.is("frame") ? constructions.get(form.text(0)) : null;
    return construction == null
        || form.parts().stream()
            .filter(part -> part.is("role"))
            .allMatch(part -> fits(construction, part.text(0), part.part(1)));
  }

  private boolean fits(Construction construction, String role, Form filler) {
    Optional<String> type =
        construction.roles().stream()
            .filter(one -> one.name().equals(role))
            .map(Construction.Role::type)
            .filter(home.vocabulary().classes()::containsKey)
            .findFirst();
    return type.isEmpty() || mayBe(filler, type.get());
  }

  private boolean mayBe(Form phrase, String type) {
    return switch (phrase.head()) {
      case "np" -> mayBe(phrase.part(phrase.parts().size() - 1), type);
      case "mod", "instate", "beside", "of", "nth" -> mayBe(phrase.part(1), type);
      case "at", "placed", "except", "other" -> mayBe(phrase.part(0), type);
      case "called" -> mayBe(phrase.part(0), type) && mayBe(phrase.part(1), type);
      case "and", "or" -> mayBe(phrase.part(0), type) && mayBe(phrase.part(1), type);
      case "noun" -> home.vocabulary().mayBeBoth(phrase.text(0), type);
      case "name" -> phrase.parts().stream().anyMatch(name -> isA(name.head(), type));
      case "speaker" ->
          home.individuals().values().stream()
              .anyMatch(one -> one.classes().contains("Listener") && one.classes().contains(type));
      default -> true;
    };
  }

  private boolean isA(String name, String type) {
    Individual individual = home.individuals().get(name);
    return individual != null && individual.classes().contains(type);
  }
}
