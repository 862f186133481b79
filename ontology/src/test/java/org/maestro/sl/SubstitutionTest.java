package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SubstitutionTest {

  @Test
  void leavesBoundVariables() {
    Formula formula = SlParser.formula("(and (in ?x ?y) (exists (?x - Item) (in ?x ?y)))");
    Substitution substitution =
        new Substitution(Map.of("x", new Term.Name("Cup"), "y", new Term.Name("zone-b")));
    assertThat(SlPrinter.print(substitution.apply(formula)))
        .isEqualTo("(and (in Cup zone-b) (exists (?x - Item) (in ?x zone-b)))");
  }

  @Test
  void renamesAQuantifiersVariableRatherThanCatchTheReplacement() {
    Formula formula = SlParser.formula("(forall (?x) (in ?x ?y))");
    assertThat(
            SlPrinter.print(new Substitution(Map.of("y", new Term.Variable("x"))).apply(formula)))
        .isEqualTo("(forall (?x_) (in ?x_ ?x))");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(forall (?x) (in ?x ?y ?x_)) | (forall (?x__) (in ?x__ ?x ?x_))",
        "(exists (?x ?x_ - Item) (in ?x ?x_ ?y)) | (exists (?x__ ?x_ - Item) (in ?x__ ?x_ ?x))",
      })
  void aRenamedVariableCatchesNoOther(String formula, String expected) {
    Substitution substitution = new Substitution(Map.of("y", new Term.Variable("x")));
    assertThat(SlPrinter.print(substitution.apply(SlParser.formula(formula)))).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(in ?x ?y) | (in Cup ?y)",
        "(not (in ?x ?y)) | (not (in Cup ?y))",
        "(unknown (in ?x ?y)) | (unknown (in Cup ?y))",
        "(= (size ?x) ?n) | (= (size Cup) 3)",
      })
  void fillsATemplateOfAFact(String fact, String expected) {
    Substitution substitution =
        new Substitution(Map.of("x", new Term.Name("Cup"), "n", new Term.Number(3)));
    assertThat(SlPrinter.print(substitution.apply(SlParser.fact(fact)))).isEqualTo(expected);
  }

  @Test
  void fillsAGoalThatIsKept() {
    Formula goal = SlParser.formula("(keep (or (unknown (lux ?x)) (in ?x a)))", "lux"::equals);
    assertThat(new Substitution(Map.of("x", new Term.Name("Cup"))).apply(goal))
        .isEqualTo(SlParser.formula("(keep (or (unknown (lux Cup)) (in Cup a)))", "lux"::equals));
  }

  @Test
  void findsFreeVariablesInOrder() {
    assertThat(
            FreeVariables.of(
                SlParser.formula("(and (p ?b) (exists (?c) (q ?c ?a)) (> (f ?d) ?b))")))
        .containsExactly("b", "a", "d");
  }

  @Property(tries = 500)
  void catchesNoVariableAndFreesNone(@ForAll("closeNames") Formula formula) {
    Map<String, Term> terms =
        Map.of("y", new Term.Variable("x"), "x__", new Term.Variable("y"), "z", new Term.Name("a"));
    Set<String> expected = new HashSet<>();
    for (String name : FreeVariables.of(formula)) {
      Term term = terms.getOrDefault(name, new Term.Variable(name));
      if (term instanceof Term.Variable variable) {
        expected.add(variable.name());
      }
    }
    assertThat(FreeVariables.of(new Substitution(terms).apply(formula)))
        .containsExactlyInAnyOrderElementsOf(expected);
  }

  @Property(tries = 200)
  void withGroundTermsLeavesNoFreeVariable(@ForAll("effects") Effect effect) {
    Map<String, Term> terms = new LinkedHashMap<>();
    FreeVariables.of(effect).forEach(name -> terms.put(name, new Term.Name("x")));
    assertThat(FreeVariables.of(new Substitution(terms).apply(effect))).isEmpty();
  }

  /** Formulas whose variables' names are those that renaming yields. */
  @Provide
  Arbitrary<Formula> closeNames() {
    Arbitrary<String> names = Arbitraries.of("x", "x_", "x__", "y", "z");
    Arbitrary<Formula> atoms =
        names
            .<Term>map(Term.Variable::new)
            .list()
            .ofMinSize(1)
            .ofMaxSize(4)
            .map(arguments -> new Formula.Atom("p", arguments));
    Arbitrary<List<TypedVariable>> variables =
        names
            .map(name -> new TypedVariable(name, Optional.empty()))
            .list()
            .uniqueElements()
            .ofMinSize(1)
            .ofMaxSize(2);
    return Arbitraries.recursive(
        () -> atoms,
        inner ->
            Arbitraries.oneOf(
                Combinators.combine(variables, inner).as(Formula.Exists::new),
                Combinators.combine(inner, atoms).as(Formula.Imply::new)),
        0,
        3);
  }

  @Provide
  Arbitrary<Effect> effects() {
    return SyntaxTrees.effects();
  }
}
