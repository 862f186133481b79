package org.maestro.language.wording;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/** What terms of a formula are called, to somebody who listens. Immutable. */
final class NamedTerms {
  private final Home home;
  private final Grammar grammar;
  private final Optional<String> listener;
  private final Map<String, Quantified> variables;
  private final Naming naming;
  private final Phrases phrases;

  /** Any of a class, or each. */
  private record Quantified(String className, boolean every) {}

  NamedTerms(Home home, Grammar grammar, Optional<String> listener) {
    this(home, grammar, listener, Map.of());
  }

  private NamedTerms(
      Home home, Grammar grammar, Optional<String> listener, Map<String, Quantified> variables) {
    this.home = home;
    this.grammar = grammar;
    this.listener = listener;
    this.variables = variables;
    this.naming = new Naming(home, grammar);
    this.phrases = new Phrases(grammar);
  }

  /**
   * The same within a quantifier.
   *
   * @param body may say more closely what it speaks of
   */
  NamedTerms within(List<TypedVariable> bound, Formula body, boolean every) {
    Map<String, Quantified> all = new HashMap<>(variables);
    for (TypedVariable variable : bound) {
      String className =
          body.parts().stream()
              .filter(part -> isClass(part, variable.name()))
              .map(part -> ((Formula.Atom) part).predicate())
              .findFirst()
              .or(variable::className)
              .orElse("Thing");
      all.put(variable.name(), new Quantified(className, every));
    }
    return new NamedTerms(home, grammar, listener, all);
  }

  private boolean isClass(Formula formula, String variable) {
    return isClass(formula)
        && ((Formula.Atom) formula).arguments().equals(List.of(new Term.Variable(variable)));
  }

  /** Whether it only tells of what kind a variable's thing is. */
  boolean isClass(Formula formula) {
    return formula instanceof Formula.Atom atom
        && atom.arguments().size() == 1
        && atom.arguments().get(0) instanceof Term.Variable
        && home.vocabulary().classes().containsKey(atom.predicate());
  }

  /** The words for what something is said of. */
  Optional<String> subject(Term term) {
    return isListener(term) ? Optional.of(phrases.of("you")) : text(term);
  }

  /** The words; none of a variable that stands for nothing. */
  Optional<String> text(Term term) {
    if (term instanceof Term.Name name) {
      return Optional.of(isListener(name) ? phrases.of("you-object") : naming.of(name));
    } else if (term instanceof Term.Number number) {
      return Optional.of(phrases.digits(number.value()));
    } else if (term instanceof Term.Text text) {
      return Optional.of(text.value());
    } else if (term instanceof Term.Variable variable) {
      return Optional.ofNullable(variables.get(variable.name())).map(this::text);
    }
    return Optional.empty();
  }

  private String text(Quantified quantified) {
    String kind = naming.word(quantified.className());
    return quantified.every() ? phrases.every(kind) : phrases.any(kind);
  }

  /** Whether it is who is spoken to. */
  boolean isListener(Term term) {
    return term instanceof Term.Name name && listener.filter(name.text()::equals).isPresent();
  }

  boolean isA(Term term, String className) {
    if (term instanceof Term.Name name) {
      Individual individual = home.individuals().get(name.text());
      return individual != null && individual.classes().contains(className);
    }
    return term instanceof Term.Variable variable
        && Optional.ofNullable(variables.get(variable.name()))
            .map(quantified -> home.vocabulary().classes().get(quantified.className()))
            .filter(of -> of.ancestors().contains(className))
            .isPresent();
  }

  /** Whether its name is one of several, such as the blinds. */
  boolean isMany(Term term) {
    if (!(term instanceof Term.Name name)) {
      return false;
    }
    Individual individual = home.individuals().get(name.text());
    return individual != null
        && individual.classes().stream()
            .filter(home.vocabulary().classes()::containsKey)
            .map(one -> grammar.inflection().of(lastWord(naming.bare(one)), "plural"))
            .anyMatch(lastWord(naming.word(name.text()))::equals);
  }

  private static String lastWord(String text) {
    return text.substring(text.lastIndexOf(' ') + 1).toLowerCase(Locale.ROOT);
  }
}
