package org.maestro.language.meaning;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.language.grammar.Form;
import org.maestro.language.reference.NounPhrases;
import org.maestro.language.reference.Reference;
import org.maestro.language.reference.Relations;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Content;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** What is asked. Bound to one reading. */
final class Questions {
  private static final String ASKED = "x";
  private static final Term.Variable VARIABLE = new Term.Variable(ASKED);
  private static final Term.Variable PLACE = new Term.Variable("where");

  private final Situation situation;
  private final References references;
  private final States states;
  private final Measures measures;
  private final Acts acts;

  Questions(
      Situation situation, References references, States states, Measures measures, Acts acts) {
    this.situation = situation;
    this.references = references;
    this.states = states;
    this.measures = measures;
    this.acts = acts;
  }

  Optional<Content> message(Form act) {
    return switch (act.head()) {
      case "ask" -> asked(act.part(0)).map(formula -> content("query-if", formula));
      case "any" -> described(act.part(0), Form.HOLE).map(f -> content("query-ref", f));
      case "which" ->
          described(nominal(act.part(0)), act.part(1)).map(f -> content("query-ref", f));
      case "who" ->
          persons().flatMap(noun -> described(noun, act.part(0))).map(f -> content("query-ref", f));
      case "what" ->
          described(Form.of("noun", Form.leaf(NounPhrases.THING)), act.part(0))
              .map(f -> content("query-ref", f));
      case "count" -> described(nominal(act.part(0)), act.part(1)).map(this::counted);
      case "where" -> where(act.part(0));
      case "value" -> value(act.part(0));
      case "attribute" -> attribute(act.part(0), act.part(1));
      case "did" -> history(act.part(0));
      case "why" -> why(act);
      default -> new Doings(situation, references).message(act);
    };
  }

  private Optional<Formula> asked(Form clause) {
    if (clause.is("happens") || clause.is("compares")) {
      return acts.condition(clause);
    }
    if (clause.is("same")) {
      return measures.comparedWith(
          Form.of("measure", clause.part(0), clause.part(1)),
          Formula.Relation.EQUAL,
          clause.part(2));
    }
    if (!clause.is("compare") && !clause.is("comparewith")) {
      return states.holding(clause.part(0), clause.part(1));
    }
    Form measure = Form.of("measure", clause.part(0), clause.part(1));
    Formula.Relation relation =
        clause.part(0).is("more") ? Formula.Relation.GREATER : Formula.Relation.LESS;
    return clause.is("compare")
        ? measures.compared(measure, relation, clause.part(2))
        : measures.comparedWith(measure, relation, clause.part(2));
  }

  private static Content content(String operator, Formula formula) {
    return new Content(operator, List.of(new Content.Argument.OfFormula(formula)));
  }

  private Content counted(Formula formula) {
    return new Content(
        "query-ref",
        List.of(
            new Content.Argument.Named("count", List.of(new Content.Argument.OfTerm(VARIABLE))),
            new Content.Argument.OfFormula(formula)));
  }

  private static Form nominal(Form said) {
    return said.is("np") ? said.part(said.parts().size() - 1) : said;
  }

  private Optional<Form> persons() {
    return NounPhrases.persons(situation.home()).map(kind -> Form.of("noun", Form.leaf(kind)));
  }

  /** What is said of the variable that is asked for. */
  private Optional<Formula> described(Form said, Form where) {
    Form phrase = said.is("that") ? said.part(0) : said;
    Form restricted = said.is("that") ? said.part(1) : where;
    Optional<NounPhrases.Asked> asked =
        references.phrases().asked(nominal(phrase), restricted, ASKED);
    if (asked.isEmpty()) {
      references.doubt(new Doubt.NoSuch(nominal(phrase)));
      return Optional.empty();
    }
    List<Formula> parts = new ArrayList<>();
    String className = asked.get().className();
    if (!className.isEmpty()) {
      parts.add(new Formula.Atom(className, List.of(VARIABLE)));
    }
    if (!asked.get().named().isEmpty()) {
      references.die();
      return Optional.empty();
    }
    parts.addAll(asked.get().conditions());
    if (parts.isEmpty()) {
      references.die();
      return Optional.empty();
    }
    return Optional.of(References.conjunction(parts));
  }

  private Optional<Content> where(Form phrase) {
    boolean isKind = phrase.is("np") && phrase.text(0).equals("all") && nominal(phrase).is("noun");
    if (isKind) {
      String className = nominal(phrase).text(0);
      return place(className)
          .map(
              predicate ->
                  content(
                      "query-ref",
                      References.conjunction(
                          List.of(
                              new Formula.Atom(className, List.of(VARIABLE)),
                              new Formula.Atom(predicate.name(), List.of(VARIABLE, PLACE))))));
    }
    Reference reference = references.phrases().resolve(phrase, "");
    return references
        .over(
            reference,
            term ->
                states.places().stream()
                    .filter(Relations::isBroughtAbout)
                    .filter(p -> references.phrases().relations().fits(p, 0, term))
                    .findFirst()
                    .or(
                        () ->
                            states.places().stream()
                                .filter(p -> references.phrases().relations().fits(p, 0, term))
                                .findFirst())
                    .map(p -> new Formula.Atom(p.name(), List.of(term, PLACE))))
        .map(formula -> content("query-ref", formula));
  }

  private Optional<PredicateDeclaration> place(String className) {
    List<PredicateDeclaration> fitting =
        states.places().stream()
            .filter(p -> references.phrases().relations().fits(p, 0, className))
            .toList();
    return fitting.stream()
        .filter(Relations::isBroughtAbout)
        .findFirst()
        .or(() -> fitting.stream().findFirst());
  }

  private Optional<Content> value(Form measure) {
    List<Expression.Fluent> fluents = measures.asked(measure);
    if (fluents.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new Content(
            "query-ref",
            fluents.stream()
                .<Content.Argument>map(
                    fluent ->
                        new Content.Argument.Named(
                            "value",
                            List.of(
                                new Content.Argument.OfFormula(
                                    new Formula.Atom(fluent.name(), fluent.arguments())))))
                .toList()));
  }

  /** What something is like: its colour, its genre. */
  private Optional<Content> attribute(Form attribute, Form phrase) {
    for (Form name : attribute.parts()) {
      Optional<PredicateDeclaration> predicate =
          situation.home().vocabulary().predicate(name.head());
      if (predicate.isEmpty()) {
        continue;
      }
      Reference of = references.phrases().resolve(phrase, Relations.typeOf(predicate.get(), 0));
      if (!(of instanceof Reference.Mistyped)) {
        return references
            .over(of, term -> Optional.of(new Formula.Atom(name.head(), List.of(term, VARIABLE))))
            .map(formula -> content("query-ref", formula));
      }
    }
    references.die();
    return Optional.empty();
  }

  private Optional<Content> history(Form verb) {
    return acts.command(verb)
        .flatMap(Acts::goalOf)
        .map(
            formula ->
                new Content(
                    "query-ref",
                    List.of(
                        new Content.Argument.Named(
                            "history",
                            List.of(
                                new Content.Argument.OfTerm(
                                    new Term.Text(SlPrinter.print(formula))))))));
  }

  private Optional<Content> why(Form act) {
    if (act.parts().isEmpty()) {
      return Optional.of(new Content("explain", List.of()));
    }
    return acts.command(act.part(0))
        .flatMap(Acts::goalOf)
        .map(
            formula ->
                new Content(
                    "explain",
                    List.of(
                        new Content.Argument.Named(
                            "goal", List.of(new Content.Argument.OfFormula(formula))))));
  }
}
