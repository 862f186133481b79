package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CandidatesTest {
  private static final List<String> ROOMS = List.of("r1", "r2", "r3", "r4", "r5", "r6");
  private static final List<String> VARIABLES = List.of("x", "y", "z");

  /** An index of all but what may be unknown. */
  private record Indexed(Facts facts) implements Facts {
    @Override
    public Truth truth(Formula.Atom atom) {
      return facts.truth(atom);
    }

    @Override
    public OptionalDouble number(Expression.Fluent fluent) {
      return facts.number(fluent);
    }

    @Override
    public Collection<Term.Name> individuals(String className) {
      return facts.individuals(className);
    }

    @Override
    public Optional<Set<Term>> candidates(Formula.Atom atom, String variable) {
      Set<Term> found = new LinkedHashSet<>();
      for (Term individual : individuals("")) {
        Formula ground = new Substitution(Map.of(variable, individual)).apply((Formula) atom);
        if (truth((Formula.Atom) ground) != Truth.FALSE) {
          found.add(individual);
        }
      }
      return atom.predicate().equals("in") ? Optional.empty() : Optional.of(found);
    }
  }

  private static final Facts FACTS =
      new TableOfFacts(
          Stream.concat(ROOMS.stream(), Stream.of("d1", "d2", "d3")).toList(),
          "(Room r1)",
          "(Room r2)",
          "(side d1 r1)",
          "(side d1 r2)",
          "(side d2 r2)",
          "(side d2 r3)",
          "(side d3 r4)",
          "(side d3 r5)",
          "(open d1)",
          "(open d3)",
          "(adjoins r5 r6)",
          "(in Cup r1)");

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(side d1 ?x) | r1 r2",
        "(side ?x r2) | d1 d2",
        "(side d1 d1) |",
        "(and (side d1 ?x) (side d2 ?x)) | r1 r2",
        "(or (side d1 ?x) (adjoins r5 ?x)) | r1 r2 r6",
        "(exists (?d) (and (side ?d r2) (side ?d ?x))) | r1 r2 r3",
        "(exists (?d) (and (side ?d r2) (side ?d ?x) (open ?d))) | r1 r2 r3",
        "(= ?x r3) | r3",
        "(= r3 ?x) | r3",
        "(not (imply (adjoins ?x r6) (open d2))) | r5",
        "(not (forall (?d) (or (not (side ?d r4)) (not (side ?d ?x))))) | r4 r5",
      })
  void areFoundInTheIndex(String formula, String individuals) {
    Optional<Set<Term>> found =
        new Candidates(new Indexed(FACTS)::candidates)
            .of(SlParser.formula(formula), true, "x", Map.of());
    if (individuals == null) {
      assertThat(found).isEmpty();
    } else {
      assertThat(found.orElseThrow().stream().map(SlPrinter::print).collect(Collectors.toSet()))
          .containsExactlyInAnyOrder(individuals.split(" "));
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(in Cup ?x)",
        "(side ?x ?x)",
        "(side ?y ?x)",
        "(not (side d1 ?x))",
        "(or (side d1 ?x) (in Cup ?x))",
        "(exists (?x) (side d1 ?x))",
        "(forall (?d) (side ?d ?x))",
        "(imply (side d1 ?x) (open d1))",
        "(= ?x 3)",
        "(= ?x ?x)",
        "(unknown (in Cup ?x))",
      })
  void areEverybodyWhereNothingNarrowsThem(String formula) {
    assertThat(
            new Candidates(new Indexed(FACTS)::candidates)
                .of(SlParser.formula(formula), true, "x", Map.of()))
        .isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(> (gain l1 ?x) 0) | r1 r2",
        "(>= (gain l1 ?x) 0.5) | r1 r2",
        "(< 3 (gain l1 ?x)) | r1 r2",
        "(<= 3 (gain ?l ?x)) | r1 r2",
        "(and (> (gain l1 ?x) 0) (side d1 r2)) | r1 r2",
        "(>= (gain l1 ?x) 0) |",
        "(> (gain l1 ?x) -1) |",
        "(< (gain l1 ?x) 3) |",
        "(= (gain l1 ?x) 3) |",
        "(not (> (gain l1 ?x) 0)) |",
        "(> (+ 1 (gain l1 ?x)) 0) |",
        "(> (gain ?x ?x) 0) |",
        "(> (gain l1 ?x) (level l1)) |",
      })
  void ofANumberThatIsToBeMoreThanNothingAreFoundInTheIndex(String formula, String individuals) {
    Candidates.Index index =
        new Candidates.Index() {
          @Override
          public Optional<Set<Term>> candidates(Formula.Atom atom, String variable) {
            return Optional.empty();
          }

          @Override
          public Optional<Set<Term>> aboveZero(Expression.Fluent fluent, String variable) {
            assertThat(SlPrinter.print(fluent)).isEqualTo("(gain l1 ?x)");
            return Optional.of(Set.of(new Term.Name("r1"), new Term.Name("r2")));
          }
        };
    Optional<Set<Term>> found =
        new Candidates(index)
            .of(
                SlParser.formula(formula, Set.of("gain", "level")::contains),
                true,
                "x",
                Map.of("l", new Term.Name("l1")));

    assertThat(found.map(Set::size)).isEqualTo(Optional.ofNullable(individuals).map(i -> 2));
  }

  @Test
  void aVariableOfAQuantifierInsideIsAnother() {
    Formula formula = SlParser.formula("(exists (?y) (and (side ?y r4) (side ?y ?x)))");
    Candidates candidates = new Candidates(new Indexed(FACTS)::candidates);
    assertThat(candidates.of(formula, true, "x", Map.of("y", new Term.Name("d1"))).orElseThrow())
        .containsExactlyInAnyOrder(new Term.Name("r4"), new Term.Name("r5"));
  }

  @Property(tries = 500)
  void nobodyIsLeftOutWithWhomItMayBeSo(
      @ForAll("formulas") Formula formula, @ForAll boolean holding) {
    Map<String, Term> others = Map.of("y", new Term.Name("r2"), "z", new Term.Name("d1"));
    Optional<Set<Term>> found =
        new Candidates(new Indexed(FACTS)::candidates).of(formula, holding, "x", others);
    for (Term.Name individual : FACTS.individuals("")) {
      Map<String, Term> bindings = new HashMap<>(others);
      bindings.put("x", individual);
      Truth truth = new Evaluation(FACTS).truth(formula, bindings);
      if (truth != Truth.of(!holding) && found.isPresent()) {
        assertThat(found.get()).contains(individual);
      }
    }
  }

  @Property(tries = 500)
  void whatIsSoWithAnIndexIsSoWithout(@ForAll("formulas") Formula formula) {
    Map<String, Term> bindings =
        Map.of("x", new Term.Name("r1"), "y", new Term.Name("r2"), "z", new Term.Name("d1"));
    assertThat(new Evaluation(new Indexed(FACTS)).truth(formula, bindings))
        .isEqualTo(new Evaluation(FACTS).truth(formula, bindings));
  }

  @Provide
  Arbitrary<Formula> formulas() {
    Arbitrary<Term> terms =
        Arbitraries.oneOf(
            Arbitraries.of(VARIABLES).map(Term.Variable::new),
            Arbitraries.of("r1", "r2", "r3", "r5", "d1", "d2", "Cup").map(Term.Name::new));
    Arbitrary<Formula> simple =
        Arbitraries.oneOf(
            Combinators.combine(Arbitraries.of("side", "adjoins", "in"), terms, terms)
                .as((name, first, second) -> new Formula.Atom(name, List.of(first, second))),
            Combinators.combine(Arbitraries.of("open", "Room"), terms)
                .as((name, term) -> new Formula.Atom(name, List.of(term))),
            Combinators.combine(terms, terms)
                .as(
                    (left, right) ->
                        new Formula.Comparison(
                            Formula.Relation.EQUAL,
                            new Expression.OfTerm(left),
                            new Expression.OfTerm(right))));
    Arbitrary<List<TypedVariable>> variables =
        Combinators.combine(Arbitraries.of(VARIABLES), Arbitraries.of("", "Room"))
            .as(
                (name, type) ->
                    new TypedVariable(name, Optional.of(type).filter(t -> !t.isEmpty())))
            .list()
            .uniqueElements(TypedVariable::name)
            .ofMinSize(1)
            .ofMaxSize(2);
    return Arbitraries.recursive(
        () -> simple,
        inner ->
            Arbitraries.oneOf(
                inner.list().ofMaxSize(3).map(Formula.And::new),
                inner.list().ofMaxSize(3).map(Formula.Or::new),
                inner.map(Formula.Not::new),
                Combinators.combine(inner, inner).as(Formula.Imply::new),
                Combinators.combine(variables, inner).as(Formula.Exists::new),
                Combinators.combine(variables, inner).as(Formula.Forall::new)),
        0,
        3);
  }
}
