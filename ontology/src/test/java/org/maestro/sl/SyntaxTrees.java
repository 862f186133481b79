package org.maestro.sl;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

/** Random trees, as the parser can yield them, over fluents whose names begin with "f". */
final class SyntaxTrees {

  private SyntaxTrees() {}

  static boolean isFluent(String name) {
    return name.startsWith("f");
  }

  /** No word of the language: from the second letter on, none is written with these alone. */
  static Arbitrary<String> names() {
    return Combinators.combine(
            Arbitraries.strings().withCharRange('a', 'z').withCharRange('A', 'Z').ofLength(1),
            Arbitraries.strings().withChars("abz-_.@%+019ü").ofMaxLength(5))
        .as((first, rest) -> first + rest);
  }

  static Arbitrary<Double> numbers() {
    return Arbitraries.oneOf(
        Arbitraries.doubles().between(-1e300, 1e300),
        Arbitraries.integers().map(Integer::doubleValue),
        Arbitraries.of(0.0, -0.0, 0.25, 1e-7, 1e15, Double.MIN_VALUE, Double.MAX_VALUE));
  }

  static Arbitrary<Term> terms() {
    return Arbitraries.oneOf(
        names().map(Term.Variable::new),
        names().map(Term.Name::new),
        names().map(name -> new Term.Iri("https://example.org/a(b)#" + name)),
        numbers().map(Term.Number::new),
        Arbitraries.strings().ofMaxLength(8).map(Term.Text::new),
        Arbitraries.of(true, false).map(Term.Truth::new));
  }

  static Arbitrary<Formula.Atom> atoms() {
    return Combinators.combine(names(), terms().list().ofMaxSize(3)).as(Formula.Atom::new);
  }

  static Arbitrary<Expression.Fluent> fluents() {
    return Combinators.combine(names(), terms().list().ofMaxSize(2))
        .as((name, arguments) -> new Expression.Fluent("f" + name, arguments));
  }

  static Arbitrary<Expression> expressions() {
    Arbitrary<Expression> simple =
        Arbitraries.oneOf(
            numbers().map(number -> new Expression.OfTerm(new Term.Number(number))),
            names().map(name -> new Expression.OfTerm(new Term.Variable(name))),
            fluents());
    return Arbitraries.recursive(
        () -> simple,
        inner ->
            Combinators.combine(
                    Arbitraries.of(Expression.Operator.values()),
                    Arbitraries.oneOf(simple, inner).list().ofMinSize(1).ofMaxSize(3))
                .as(Expression.Arithmetic::new),
        0,
        2);
  }

  static Arbitrary<List<TypedVariable>> variables() {
    return Combinators.combine(names(), names().optional())
        .as(TypedVariable::new)
        .list()
        .ofMinSize(1)
        .ofMaxSize(2);
  }

  static Arbitrary<Formula> formulas() {
    Arbitrary<Formula> simple =
        Arbitraries.oneOf(
            atoms(),
            Combinators.combine(
                    Arbitraries.of(Formula.Relation.values()), expressions(), expressions())
                .as(Formula.Comparison::new),
            Combinators.combine(terms(), terms())
                .as(
                    (left, right) ->
                        new Formula.Comparison(
                            Formula.Relation.EQUAL,
                            new Expression.OfTerm(left),
                            new Expression.OfTerm(right))),
            atoms().filter(atom -> !isFluent(atom.predicate())).map(Formula.UnknownAtom::new),
            fluents().map(Formula.UnknownNumber::new));
    return Arbitraries.recursive(
        () -> simple,
        inner ->
            Arbitraries.oneOf(
                inner.list().ofMaxSize(3).map(Formula.And::new),
                inner.list().ofMaxSize(3).map(Formula.Or::new),
                inner.map(Formula.Not::new),
                Combinators.combine(inner, inner).as(Formula.Imply::new),
                Combinators.combine(variables(), inner).as(Formula.Exists::new),
                Combinators.combine(variables(), inner).as(Formula.Forall::new)),
        0,
        3);
  }

  static Arbitrary<Effect> effects() {
    Arbitrary<Effect> simple =
        Arbitraries.oneOf(
            atoms().map(Effect.Add::new),
            atoms().map(Effect.Delete::new),
            Combinators.combine(
                    Arbitraries.of(Effect.Assignment.values()), fluents(), expressions())
                .as(Effect.Change::new),
            atoms().filter(atom -> !isFluent(atom.predicate())).map(Effect.SenseAtom::new),
            fluents().map(Effect.SenseNumber::new));
    return Arbitraries.recursive(
        () -> simple,
        inner ->
            Arbitraries.oneOf(
                inner.list().ofMaxSize(3).map(Effect.All::new),
                Combinators.combine(formulas(), inner).as(Effect.When::new),
                Combinators.combine(variables(), inner).as(Effect.Forall::new)),
        0,
        2);
  }

  static Arbitrary<Body> bodies() {
    return Arbitraries.oneOf(
        Arbitraries.recursive(SyntaxTrees::steps, SyntaxTrees::bodiesOf, 0, 3),
        questions(Arbitraries.just(List.of())));
  }

  private static Arbitrary<Body> questions(Arbitrary<List<Body>> parts) {
    Arbitrary<List<Term>> words = terms().list().ofMinSize(1).ofMaxSize(3);
    return Arbitraries.oneOf(
        Combinators.combine(
                terms(),
                words,
                Combinators.combine(names(), names().optional()).as(TypedVariable::new),
                parts)
            .as(Body.Ask::new),
        Combinators.combine(terms(), words, names(), answerFormats(), parts)
            .as(
                (who, asked, name, format, inside) ->
                    new Body.Ask(
                        who,
                        asked,
                        new TypedVariable(name, Optional.empty()),
                        Optional.of(format),
                        inside)));
  }

  private static Arbitrary<AnswerFormat> answerFormats() {
    Arbitrary<String> labels = Arbitraries.strings().ofMaxLength(8);
    return Arbitraries.oneOf(
        terms().list().ofMinSize(1).ofMaxSize(3).map(AnswerFormat.Choice::new),
        Combinators.combine(numbers(), numbers(), numbers(), labels, labels)
            .as(AnswerFormat.Slider::new));
  }

  private static Arbitrary<Body> steps() {
    return Arbitraries.oneOf(
        formulas().map(Body.Achieve::new),
        Combinators.combine(names(), terms(), Arbitraries.maps(names(), terms()).ofMaxSize(3))
            .as(Body.Do::new),
        runs().map(run -> run),
        Combinators.combine(terms(), terms().list().ofMinSize(1).ofMaxSize(3)).as(Body.Say::new),
        Combinators.combine(terms(), contents()).as(Body.Tell::new),
        effects().map(Body.Assert::new),
        formulas().map(Body.Await::new),
        Arbitraries.oneOf(numbers().map(Term.Number::new), names().map(Term.Variable::new))
            .map(term -> new Body.Pause(new Expression.OfTerm(term))),
        terms().map(Body.Look::new),
        Combinators.combine(terms(), terms()).as(Body.Express::new),
        terms().map(Body.Return::new),
        Arbitraries.strings().ofMaxLength(8).map(Body.Fail::new));
  }

  private static Arbitrary<Body> bodiesOf(Arbitrary<Body> inner) {
    Arbitrary<List<Body>> parts = inner.list().ofMinSize(1).ofMaxSize(3);
    Arbitrary<Body.Recovery> recoveries =
        Combinators.combine(Arbitraries.strings().ofMaxLength(8).optional(), inner)
            .as(Body.Recovery::new);
    return Arbitraries.oneOf(
        parts.map(Body.Seq::new),
        parts.map(Body.Par::new),
        Combinators.combine(formulas(), inner, inner.optional()).as(Body.If::new),
        Combinators.combine(
                formulas(), inner, Arbitraries.integers().between(1, 999_999_999).optional())
            .as(
                (condition, body, most) ->
                    new Body.While(
                        condition, body, most.map(OptionalInt::of).orElseGet(OptionalInt::empty))),
        Combinators.combine(variable(), formulas(), inner).as(Body.ForEach::new),
        Combinators.combine(names(), sources(), parts).as(Body.Let::new),
        Combinators.combine(terms(), Arbitraries.strings().ofMaxLength(8), parts)
            .as(Body.Hold::new),
        questions(parts),
        Combinators.combine(formulas(), terms(), Arbitraries.strings().ofMaxLength(8))
            .as(
                (condition, member, component) ->
                    new Body.While(
                        condition,
                        new Body.Hold(member, component, List.of()),
                        OptionalInt.empty())),
        Combinators.combine(inner, recoveries.list().ofMaxSize(2), inner.optional())
            .as(Body.Try::new)
            .filter(attempt -> !attempt.recoveries().isEmpty() || attempt.last().isPresent()));
  }

  private static Arbitrary<Body.Source> sources() {
    return Arbitraries.oneOf(
        expressions().map(Body.Source.Value::new),
        Combinators.combine(variable(), formulas()).as(Body.Source.One::new),
        runs().map(run -> run));
  }

  private static Arbitrary<Body.Run> runs() {
    return Combinators.combine(names(), terms().list().ofMaxSize(3)).as(Body.Run::new);
  }

  private static Arbitrary<TypedVariable> variable() {
    return variables().map(variables -> variables.get(0));
  }

  static Arbitrary<Fact> facts() {
    return Arbitraries.oneOf(
        atoms().map(Fact.Holds::new),
        atoms().map(Fact.Excluded::new),
        atoms().map(Fact.Unknown::new),
        Combinators.combine(fluents(), terms()).as(Fact.Equation::new));
  }

  static Arbitrary<Content> contents() {
    Arbitrary<Content.Argument> simple =
        Arbitraries.oneOf(
            formulas().map(Content.Argument.OfFormula::new),
            terms().map(Content.Argument.OfTerm::new),
            Combinators.combine(fluents(), expressions())
                .as(
                    (fluent, value) ->
                        new Content.Argument.OfEffect(
                            new Effect.Change(Effect.Assignment.ASSIGN, fluent, value))));
    return Combinators.combine(
            Arbitraries.of("initCNP", "perform", "cost"),
            Arbitraries.recursive(
                    () -> simple,
                    inner ->
                        Arbitraries.oneOf(
                            Combinators.combine(names(), inner.list().ofMaxSize(2))
                                .as(Content.Argument.Named::new),
                            Combinators.combine(
                                    Arbitraries.of("inform", "query-ref"),
                                    inner.list().ofMaxSize(2))
                                .as(
                                    (operator, arguments) ->
                                        new Content.Argument.Nested(
                                            new Content(operator, arguments)))),
                    0,
                    2)
                .list()
                .ofMaxSize(3))
        .as(Content::new);
  }
}
