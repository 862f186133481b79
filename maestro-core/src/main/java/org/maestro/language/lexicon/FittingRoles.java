package org.maestro.language.lexicon;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.maestro.language.grammar.Form;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.ClassDeclaration;
import org.maestro.ontology.wording.Construction;

/**
 * Whether what fills a construction's roles may be of their classes, as far as words alone tell.
 * Immutable.
 */
public final class FittingRoles implements Predicate<Form> {
  private final Home home;
  private final Map<String, Construction> constructions = new HashMap<>();

  /** By class, those with which it may have a member in common. */
  private final Map<String, Set<String>> common = new HashMap<>();

  /** The classes of those who may speak. */
  private final Set<String> speaking = new HashSet<>();

  public FittingRoles(Home home) {
    this.home = home;
    home.wording().constructions().forEach(one -> constructions.put(one.name(), one));
    for (ClassDeclaration declared : home.vocabulary().classes().values()) {
      Set<String> all = new HashSet<>(declared.ancestors());
      all.add(declared.name());
      all.forEach(name -> common.computeIfAbsent(name, n -> new HashSet<>()).addAll(all));
    }
    home.individuals().values().stream()
        .filter(one -> one.classes().contains("Listener"))
        .forEach(one -> speaking.addAll(one.classes()));
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
      case "mod", "instate", "beside", "of", "nth", "extreme", "around" ->
          mayBe(phrase.part(1), type);
      case "at", "placed", "except", "other" -> mayBe(phrase.part(0), type);
      case "called" -> mayBe(phrase.part(0), type) && mayBe(phrase.part(1), type);
      case "and", "or" -> mayBe(phrase.part(0), type) && mayBe(phrase.part(1), type);
      case "noun" -> common.getOrDefault(phrase.text(0), Set.of()).contains(type);
      case "name" -> phrase.parts().stream().anyMatch(name -> isA(name.head(), type));
      case "speaker" -> speaking.contains(type);
      default -> true;
    };
  }

  private boolean isA(String name, String type) {
    Individual individual = home.individuals().get(name);
    return individual != null && individual.classes().contains(type);
  }
}
