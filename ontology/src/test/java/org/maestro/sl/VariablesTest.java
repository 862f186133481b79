package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Which variables are free, and which stand for numbers. */
class VariablesTest {

  @Test
  void eachFormOfAFormulaShowsItsFreeVariablesInOrder() {
    Formula goal =
        SlParser.formula(
            "(keep (and (p ?a) (or (not (q ?b)) (imply (r ?c) (s ?d))) (unknown (t ?e))"
                + " (unknown (lux ?f)) (= (+ ?g (lux ?h) 1) ?i) (forall (?z) (u ?z ?j))))",
            "lux"::equals);
    assertThat(FreeVariables.of(goal))
        .containsExactly("a", "b", "c", "d", "e", "f", "g", "h", "i", "j");
  }

  @Test
  void eachFormOfAnEffectShowsItsFreeVariablesInOrder() {
    Effect effect =
        SlParser.effect(
            "(and (p ?a) (not (q ?b)) (when (r ?c) (s ?d)) (forall (?z) (t ?z ?e))"
                + " (increase (level ?f) (* 2 ?g)) (sense (u ?h)) (sense (lux ?i)))",
            "lux"::equals);
    assertThat(FreeVariables.of(effect))
        .containsExactly("a", "b", "c", "d", "e", "f", "g", "h", "i");
  }

  @ParameterizedTest
  @CsvSource({
    "(and (exists (?x) (p ?x)) (q ?x)), x",
    "(and (forall (?x ?y) (p ?x ?y)) (q ?y)), y",
    "(exists (?x) (and (forall (?x) (p ?x)) (q ?x ?y))), y"
  })
  void aVariableIsBoundInItsQuantifierOnly(String formula, String free) {
    assertThat(FreeVariables.of(SlParser.formula(formula))).containsExactly(free);
  }

  @Test
  void aVariableIsBoundInItsQuantifiedEffectOnly() {
    assertThat(FreeVariables.of(SlParser.effect("(and (forall (?x) (p ?x)) (q ?x))")))
        .containsExactly("x");
  }

  @ParameterizedTest
  @CsvSource({
    "(p ?b ?a)",
    "(not (p ?b ?a))",
    "(unknown (p ?b ?a))",
    "(= (level ?b) ?a)",
  })
  void aFactShowsItsVariables(String fact) {
    assertThat(FreeVariables.of(SlParser.fact(fact))).containsExactly("b", "a");
  }

  @Test
  void anExpressionShowsItsVariables() {
    assertThat(FreeVariables.of(SlParser.expression("(max ?b (level ?a x) 3)")))
        .containsExactly("b", "a");
  }

  @Test
  void aVariableIsANumberWhereItIsComparedOrReckonedWith() {
    Formula formula =
        SlParser.formula(
            "(and (> ?a 5) (= ?b (level lamp)) (= 3 ?c) (exists (?d) (< (+ ?e 1) ?d)))");
    assertThat(NumberVariables.of(formula)).containsExactly("a", "b", "c", "e", "d");
  }

  @Test
  void aVariableIsNoNumberWhereAnIndividualCanBe() {
    Formula formula =
        SlParser.formula("(and (in ?a b) (= ?c Cup) (= ?d ?e) (> (level ?f) 3) (= (level ?g) 3))");
    assertThat(NumberVariables.of(formula)).isEmpty();
    assertThat(NumberVariables.equationsIn(formula)).isEmpty();
  }

  @Test
  void anEquationTellsAVariablesNumberFromEitherSide() {
    Formula formula =
        SlParser.formula(
            "(and (= ?b (level lamp)) (or (= 3 ?b)) (= ?c (+ ?b 1)) (> ?a 5) (= 4 (level lamp)))");
    assertThat(NumberVariables.equationsIn(formula))
        .containsOnlyKeys("b", "c")
        .containsEntry("b", List.of(SlParser.expression("(level lamp)"), SlParser.expression("3")))
        .containsEntry("c", List.of(SlParser.expression("(+ ?b 1)")));
  }
}
