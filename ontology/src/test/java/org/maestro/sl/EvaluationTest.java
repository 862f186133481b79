package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class EvaluationTest {

  private final Facts facts =
      new TableOfFacts(
          List.of("a", "b", "Cup"),
          "(Zone a)",
          "(Zone b)",
          "(in Cup a)",
          "(not (in Bob a))",
          "(= (lux a) 72)",
          "(= (gain a) 30)",
          "(= (gain b) 10)");
  private final Evaluation evaluation = new Evaluation(facts);

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(in Cup a) | TRUE",
        "(in Bob a) | FALSE",
        "(in Bob b) | UNKNOWN",
        "(not (in Bob b)) | UNKNOWN",
        "(unknown (in Bob b)) | TRUE",
        "(unknown (in Bob a)) | FALSE",
        "(unknown (lux b)) | TRUE",
        "(unknown (lux a)) | FALSE",
        "(and (in Cup a) (in Bob b)) | UNKNOWN",
        "(and (in Bob a) (in Bob b)) | FALSE",
        "(and) | TRUE",
        "(or (in Cup a) (in Bob b)) | TRUE",
        "(or (in Bob a) (in Bob b)) | UNKNOWN",
        "(or (in Bob b) (in Bob a)) | UNKNOWN",
        "(or (in Bob a) (Zone Cup)) | FALSE",
        "(imply (in Bob b) (in Cup a)) | TRUE",
        "(or) | FALSE",
        "(imply (in Bob a) (in Bob b)) | TRUE",
        "(imply (in Cup a) (in Bob b)) | UNKNOWN",
        "(>= (lux a) 72) | TRUE",
        "(> (lux a) 72) | FALSE",
        "(<= (lux b) 72) | UNKNOWN",
        "(= (+ 0.1 0.2) 0.3) | TRUE",
        "(< (max 1 (lux b)) 2) | UNKNOWN",
        "(= a a) | TRUE",
        "(= a b) | FALSE",
        "(= a 1) | FALSE",
        "(= true true) | TRUE",
        "(= (/ 1 0) 1) | UNKNOWN",
        "(exists (?z - Zone) (in Bob ?z)) | UNKNOWN",
        "(exists (?z - Zone) (in Cup ?z)) | TRUE",
        "(forall (?z - Zone) (> (gain ?z) 5)) | TRUE",
        "(forall (?z - Zone) (> (gain ?z) 15)) | FALSE",
        "(forall (?z - Zone) (> (lux ?z) 15)) | UNKNOWN",
        "(exists (?x ?z - Zone) (in ?x ?z)) | TRUE",
        "(keep (in Cup a)) | TRUE",
      })
  void isThreeValued(String formula, Truth expected) {
    assertThat(evaluation.truth(SlParser.formula(formula, "lux"::equals), Map.of()))
        .isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource({
    "(= 1e-9 0), TRUE", "(= -1e-9 0), TRUE", "(= 2e-9 0), FALSE", "(= -2e-9 0), FALSE",
    "(< -1e-9 0), FALSE", "(< -2e-9 0), TRUE", "(< 1 2), TRUE", "(< 2 1), FALSE",
    "(<= 1e-9 0), TRUE", "(<= 2e-9 0), FALSE", "(<= 1 2), TRUE", "(<= 2 1), FALSE",
    "(> 1e-9 0), FALSE", "(> 2e-9 0), TRUE", "(> 1 2), FALSE", "(> 2 1), TRUE",
    "(>= -1e-9 0), TRUE", "(>= -2e-9 0), FALSE", "(>= 1 2), FALSE", "(>= 2 1), TRUE"
  })
  void aBillionthMakesNoNumberAnother(String comparison, Truth expected) {
    assertThat(evaluation.truth(SlParser.formula(comparison), Map.of())).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource({"(- 3),-3", "(- 3 1 1),1", "(* 2 (gain a)),60", "(min 2 1),1", "(max 0 (- 1 3)),0"})
  void calculates(String expression, double expected) {
    assertThat(evaluation.number(SlParser.expression(expression), Map.of())).hasValue(expected);
  }

  @Test
  void readsAllValuesBeforeTheStep() {
    Effect effect =
        SlParser.effect(
            "(and (assign (lux a) 5) (increase (gain a) (lux a)) (decrease (gain a) 1)"
                + " (increase (lux b) 1) (lit a) (not (in Cup a)) (not (lit a)) (sense (in Bob b))"
                + " (when (in Bob b) (wrong a)) (forall (?z - Zone) (when (= ?z ?where) (done ?z))))");
    assertThat(evaluation.changes(effect, Map.of("where", new Term.Name("b"))))
        .containsExactly(
            new Change.OfTruth(atom("(in Cup a)"), false),
            new Change.OfTruth(atom("(lit a)"), true),
            new Change.OfTruth(atom("(done b)"), true),
            new Change.OfNumber(fluent("(lux a)"), OptionalDouble.of(5)),
            new Change.OfNumber(fluent("(gain a)"), OptionalDouble.of(101)),
            new Change.OfNumber(fluent("(lux b)"), OptionalDouble.empty()));
  }

  @Test
  void namesAVariableWithoutValue() {
    assertThatThrownBy(() -> evaluation.truth(SlParser.formula("(in ?x a)"), Map.of()))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("?x");
  }

  @Test
  void whatIsNotKnownDoesNotHoldWhereOnlyTheKnownCounts() {
    Facts known = new OnlyKnown(facts);
    assertThat(known.truth(atom("(in Cup a)"))).isEqualTo(Truth.TRUE);
    assertThat(known.truth(atom("(in Bob a)"))).isEqualTo(Truth.FALSE);
    assertThat(known.truth(atom("(in Bob b)"))).isEqualTo(Truth.FALSE);
    assertThat(known.number(fluent("(lux a)"))).hasValue(72);
    assertThat(known.number(fluent("(lux b)"))).isEmpty();
    assertThat(known.individuals("Zone")).containsExactly(new Term.Name("a"), new Term.Name("b"));
  }

  @Test
  void theSpeakerIsSelfWhateverElseIsBound() {
    Map<String, Term> others = Map.of("self", new Term.Name("Bob"), "where", new Term.Name("a"));
    assertThat(evaluation.truth(SlParser.formula("(in ?self a)"), Self.is("Cup")))
        .isEqualTo(Truth.TRUE);
    assertThat(evaluation.truth(SlParser.formula("(in ?self ?where)"), Self.is("Cup", others)))
        .isEqualTo(Truth.TRUE);
  }

  private static Formula.Atom atom(String text) {
    return (Formula.Atom) SlParser.formula(text);
  }

  private static Expression.Fluent fluent(String text) {
    return (Expression.Fluent) SlParser.expression(text);
  }
}
