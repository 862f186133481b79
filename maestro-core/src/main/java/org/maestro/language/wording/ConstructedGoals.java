package org.maestro.language.wording;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Script;
import org.maestro.ontology.wording.Construction;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/** The goals that a home's constructions state, with their roles as variables. Immutable. */
final class ConstructedGoals {
  private final Home home;

  ConstructedGoals(Home home) {
    this.home = home;
  }

  /** The goal of a construction; of one that has a script performed the script as a goal. */
  Optional<Formula> goal(Construction construction) {
    return stated(construction).or(() -> performed(construction));
  }

  /** The goal that a construction states. */
  static Optional<Formula> stated(Construction construction) {
    return construction
        .means()
        .filter(means -> means.operator().equals("initCNP") && means.arguments().size() == 1)
        .map(means -> means.arguments().get(0))
        .filter(Content.Argument.Named.class::isInstance)
        .flatMap(goal -> ((Content.Argument.Named) goal).arguments().stream().findFirst())
        .filter(Content.Argument.OfFormula.class::isInstance)
        .map(goal -> ((Content.Argument.OfFormula) goal).formula());
  }

  /** The script that a construction has performed, as it is asked for in a goal. */
  private Optional<Formula> performed(Construction construction) {
    Optional<Content> means =
        construction.means().filter(message -> message.operator().equals("perform"));
    Optional<Script> script =
        means
            .flatMap(message -> argument(message, "script"))
            .filter(Term.Name.class::isInstance)
            .map(name -> home.scripts().get(((Term.Name) name).text()));
    if (script.isEmpty()) {
      return Optional.empty();
    }
    List<Term> arguments = new ArrayList<>();
    for (TypedVariable parameter : script.get().parameters()) {
      argument(means.get(), parameter.name()).ifPresent(arguments::add);
    }
    return arguments.size() == script.get().parameters().size()
        ? Optional.of(new Formula.Atom(script.get().name(), arguments))
        : Optional.empty();
  }

  private static Optional<Term> argument(Content message, String name) {
    return message.arguments().stream()
        .filter(Content.Argument.Named.class::isInstance)
        .map(Content.Argument.Named.class::cast)
        .filter(named -> named.name().equals(name))
        .flatMap(named -> named.arguments().stream())
        .filter(Content.Argument.OfTerm.class::isInstance)
        .map(term -> ((Content.Argument.OfTerm) term).term())
        .findFirst();
  }
}
