package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class LeavesTest {

  private final List<String> found = new ArrayList<>();

  private void atom(Formula.Atom atom) {
    found.add("atom " + SlPrinter.print(atom));
  }

  private void fluent(Expression.Fluent fluent) {
    found.add("fluent " + SlPrinter.print(fluent));
  }

  @Test
  void areVisitedInOrderWhateverStandsAroundThem() {
    Formula goal =
        SlParser.formula(
            "(keep (exists (?x) (and (p ?x) (or (not (q a)) (imply (r a) (> (+ 1 (f ?x)) (g))))"
                + " (forall (?y) (unknown (s ?y))) (unknown (lux a)))))",
            "lux"::equals);
    Leaves.of(goal, this::atom, this::fluent);
    assertThat(found)
        .containsExactly(
            "atom (p ?x)",
            "atom (q a)",
            "atom (r a)",
            "fluent (f ?x)",
            "fluent (g)",
            "atom (s ?y)",
            "fluent (lux a)");
  }

  @Test
  void ofAnExpressionAreItsFluents() {
    Leaves.of(SlParser.expression("(- (f a) (max ?n 2 (g)))"), this::fluent);
    assertThat(found).containsExactly("fluent (f a)", "fluent (g)");
  }
}
