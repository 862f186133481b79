package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

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

  @Test
  void findsFreeVariablesInOrder() {
    assertThat(
            FreeVariables.of(
                SlParser.formula("(and (p ?b) (exists (?c) (q ?c ?a)) (> (f ?d) ?b))")))
        .containsExactly("b", "a", "d");
  }

  @Property(tries = 200)
  void withGroundTermsLeavesNoFreeVariable(@ForAll("effects") Effect effect) {
    Map<String, Term> terms = new java.util.LinkedHashMap<>();
    FreeVariables.of(effect).forEach(name -> terms.put(name, new Term.Name("x")));
    assertThat(FreeVariables.of(new Substitution(terms).apply(effect))).isEmpty();
  }

  @Provide
  Arbitrary<Effect> effects() {
    return SyntaxTrees.effects();
  }
}
