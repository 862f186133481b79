package org.maestro.language.meaning;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Script;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.Occasion;
import org.maestro.sl.Term;

/** The goals that a message states, those too that it states for later. */
public final class Wishes {
  private Wishes() {}

  /** In the order in which they are said; none of what is no wish. */
  public static List<Formula> of(Content message, Home home) {
    return switch (message.operator()) {
      case "initCNP" -> Acts.goalOf(message).stream().toList();
      case "perform" -> runs(message, home);
      case "seq" -> nested(message).flatMap(part -> of(part, home).stream()).toList();
      case "whenever", "once", "at", "after", "until" ->
          nested(message)
              .flatMap(part -> of(part, home).stream())
              .<Formula>map(goal -> new Formula.Upon(new Occasion.After(0), goal))
              .toList();
      default -> List.of();
    };
  }

  private static Stream<Content> nested(Content message) {
    return message.arguments().stream()
        .filter(Content.Argument.Nested.class::isInstance)
        .map(part -> ((Content.Argument.Nested) part).content());
  }

  /** A script for each value that is named of several; what is not named is open. */
  private static List<Formula> runs(Content message, Home home) {
    Optional<Script> script =
        terms(message, "script").stream()
            .filter(Term.Name.class::isInstance)
            .map(name -> ((Term.Name) name).text())
            .flatMap(name -> Optional.ofNullable(home.scripts().get(name)).stream())
            .findFirst();
    if (script.isEmpty()) {
      return List.of();
    }
    List<List<Term>> calls = List.of(List.of());
    for (var parameter : script.get().parameters()) {
      List<Term> said = terms(message, parameter.name());
      List<Term> values = said.isEmpty() ? List.of(new Term.Variable(parameter.name())) : said;
      calls =
          calls.stream().flatMap(call -> values.stream().map(value -> with(call, value))).toList();
    }
    return calls.stream()
        .<Formula>map(call -> new Formula.Atom(script.get().name(), call))
        .toList();
  }

  private static List<Term> with(List<Term> call, Term value) {
    List<Term> longer = new ArrayList<>(call);
    longer.add(value);
    return longer;
  }

  private static List<Term> terms(Content message, String name) {
    return message.arguments().stream()
        .filter(Content.Argument.Named.class::isInstance)
        .map(Content.Argument.Named.class::cast)
        .filter(one -> one.name().equals(name))
        .flatMap(one -> one.arguments().stream())
        .filter(Content.Argument.OfTerm.class::isInstance)
        .map(one -> ((Content.Argument.OfTerm) one).term())
        .toList();
  }
}
