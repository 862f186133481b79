package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

class PrinterIsInverseTest {

  @Property(tries = 300)
  void ofFormulas(@ForAll("formulas") Formula formula) {
    assertThat(SlParser.formula(SlPrinter.print(formula), SyntaxTrees::isFluent))
        .isEqualTo(formula);
  }

  @Property(tries = 100)
  void ofKeptGoals(@ForAll("formulas") Formula formula) {
    Formula goal = new Formula.Keep(formula);
    assertThat(SlParser.formula(SlPrinter.print(goal), SyntaxTrees::isFluent)).isEqualTo(goal);
  }

  @Property(tries = 300)
  void ofEffects(@ForAll("effects") Effect effect) {
    assertThat(SlParser.effect(SlPrinter.print(effect), SyntaxTrees::isFluent)).isEqualTo(effect);
  }

  @Property(tries = 300)
  void ofBodies(@ForAll("bodies") Body body) {
    assertThat(SlParser.body(SlPrinter.print(body), SyntaxTrees::isFluent)).isEqualTo(body);
  }

  @Property(tries = 300)
  void ofExpressions(@ForAll("expressions") Expression expression) {
    assertThat(SlParser.expression(SlPrinter.print(expression))).isEqualTo(expression);
  }

  @Property(tries = 300)
  void ofTerms(@ForAll("terms") Term term) {
    assertThat(SlParser.term(SlPrinter.print(term))).isEqualTo(term);
  }

  @Property(tries = 200)
  void ofFacts(@ForAll("facts") Fact fact) {
    assertThat(SlParser.fact(SlPrinter.print(fact))).isEqualTo(fact);
  }

  @Property(tries = 200)
  void ofVariables(@ForAll("variables") List<TypedVariable> variables) {
    TypedVariable variable = variables.get(0);
    assertThat(SlParser.variable(SlPrinter.print(variable))).isEqualTo(variable);
  }

  @Property(tries = 300)
  void ofContents(@ForAll("contents") Content content) {
    assertThat(SlParser.content(SlPrinter.print(content), SyntaxTrees::isFluent))
        .containsExactly(content);
  }

  @Provide
  Arbitrary<Formula> formulas() {
    return SyntaxTrees.formulas();
  }

  @Provide
  Arbitrary<Effect> effects() {
    return SyntaxTrees.effects();
  }

  @Provide
  Arbitrary<Body> bodies() {
    return SyntaxTrees.bodies();
  }

  @Provide
  Arbitrary<Expression> expressions() {
    return SyntaxTrees.expressions();
  }

  @Provide
  Arbitrary<Term> terms() {
    return SyntaxTrees.terms();
  }

  @Provide
  Arbitrary<Fact> facts() {
    return SyntaxTrees.facts();
  }

  @Provide
  Arbitrary<List<TypedVariable>> variables() {
    return SyntaxTrees.variables();
  }

  @Provide
  Arbitrary<Content> contents() {
    return SyntaxTrees.contents();
  }
}
