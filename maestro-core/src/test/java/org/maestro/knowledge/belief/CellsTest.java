package org.maestro.knowledge.belief;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.sl.Term;

class CellsTest {

  @Test
  void eachVersionKeepsWhatItKnewAndTheOrderIsThatOfFirstMention() {
    List<Cells> versions = new ArrayList<>();
    Cells cells = Cells.none();
    for (int i = 0; i < 3_000; i++) {
      versions.add(cells);
      cells = cells.with(variable(i), cell(i));
    }
    Cells changed = cells.with(variable(7), cell(-7));

    for (int i : new int[] {0, 1, 31, 32, 33, 1_023, 1_024, 1_025, 2_999}) {
      assertThat(versions.get(i).get(variable(i))).as("before %d", i).isEmpty();
      assertThat(value(cells, i)).isEqualTo(i);
      assertThat(value(changed, i)).isEqualTo(i);
    }
    assertThat(value(cells, 7)).isEqualTo(7);
    assertThat(value(changed, 7)).isEqualTo(-7);
    assertThat(cells.get(variable(3_000))).isEmpty();
    List<StateVariable> seen = new ArrayList<>();
    versions.get(40).forEach((variable, cell) -> seen.add(variable));
    assertThat(seen).hasSize(40).startsWith(variable(0), variable(1)).endsWith(variable(39));
  }

  private static double value(Cells cells, int i) {
    Held held = cells.get(variable(i)).orElseThrow().value().orElseThrow();
    return ((Term.Number) held.value()).value();
  }

  private static StateVariable variable(int i) {
    return new StateVariable("level", List.of(new Term.Name("lamp-" + i)));
  }

  private static Cell cell(double value) {
    Held held =
        new Held(
            new Term.Number(value),
            new Source(Source.Kind.OBSERVED, "sensor"),
            Instant.EPOCH,
            Instant.MAX,
            Instant.EPOCH,
            1,
            false,
            OptionalDouble.empty(),
            0);
    return Cell.LOST.with(new Claim(held, true), Instant.EPOCH);
  }
}
